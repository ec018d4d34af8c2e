#include "name_patterns.h"

#include <algorithm>

#include "base/split.h"

namespace taut {
namespace {

// A name with a star in place of some of its parts; empty where it has another number of parts.
std::string with_stars(std::string_view name, const std::vector<bool>& stars) {
  std::string starred;
  for (std::size_t part = 0; part < stars.size(); ++part) {
    const std::size_t dot = name.find('.');
    const bool last = part + 1 == stars.size();
    if (last != (dot == std::string_view::npos)) return {};
    starred += stars[part] ? std::string_view("*") : name.substr(0, dot);
    if (last) break;
    starred += '.';
    name.remove_prefix(dot + 1);
  }
  return starred;
}

std::vector<bool> stars_of(std::string_view pattern) {
  std::vector<bool> stars;
  for (;;) {
    const std::size_t dot = pattern.find('.');
    stars.push_back(pattern.substr(0, dot) == "*");
    if (dot == std::string_view::npos) return stars;
    pattern.remove_prefix(dot + 1);
  }
}

}  // namespace

const NamePatterns::ByRest& NamePatterns::names_without(const std::vector<bool>& stars) {
  const auto [known, is_new] = by_stars_.try_emplace(stars);
  if (!is_new) return known->second;
  for (Index mass = 0; mass < masses_.size(); ++mass) {
    std::string starred = with_stars(masses_.name[mass], stars);
    if (!starred.empty()) known->second[std::move(starred)].push_back(mass);
  }
  return known->second;
}

const std::vector<Index>& NamePatterns::fitting(std::string_view pattern) {
  constexpr std::size_t most_parts = 8;  // no builder names masses so deep
  const std::vector<bool> stars = stars_of(pattern);
  if (stars.size() > most_parts) return none_;
  const ByRest& names = names_without(stars);
  const auto found = names.find(std::string(pattern));
  return found == names.end() ? none_ : found->second;
}

}  // namespace taut
