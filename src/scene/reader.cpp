#include "reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace taut {
namespace {

constexpr std::size_t most_kept = 10'000, most_counted = 100'000;

template <std::size_t count>
bool is_one_of(std::string_view word, const std::array<std::string_view, count>& words) {
  return std::ranges::find(words, word) != words.end();
}

// Whether masses are made of the entries of a section. An empty one is the top level: an unknown section may
// have been meant to hold masses.
bool makes_masses(std::string_view section) {
  static constexpr std::array<std::string_view, 7> sections{"",     "mass",   "chain",  "sheet",
                                                            "mesh", "points", "ragdoll"};
  return is_one_of(section, sections);
}

// Whether a key decides how many masses an entry has, or what they are called. Of files and bodies any may:
// welding and a list of parts do. Without a key it is the entry itself that can't be read.
bool decides_names(std::string_view section, std::string_view key) {
  static constexpr std::array<std::string_view, 3> by_few{"mass", "chain", "sheet"};
  static constexpr std::array<std::string_view, 4> few{"name", "links", "rows", "columns"};
  return !is_one_of(section, by_few) || key.empty() || is_one_of(key, few);
}

}  // namespace

void Reader::begin_entry(std::string_view section, std::size_t index) {
  entry_ = {std::string(section), index};
  key_.clear();
}

bool Reader::full() const {
  return count() >= most_counted;
}

std::string Reader::home_hint(std::string_view key) const {
  std::string labels;
  const auto [begin, end] = homes_.equal_range(key);
  for (auto home = begin; home != end; ++home)
    labels += fmt::format("{}{}", labels.empty() ? "" : ", ", home->second);
  return labels.empty() ? labels : fmt::format("{} is a key of {}", in_quotes(key), labels);
}

Diagnostic Reader::located(const Origin& origin, std::string message, std::string hint) const {
  const bool in_file = origin.change < 0;
  return {in_file ? file_ : changes_[static_cast<std::size_t>(origin.change)], in_file ? origin.line : 0,
          in_file ? origin.column : 0, std::move(message), std::move(hint)};
}

void Reader::plain(const Origin& origin, std::string message, std::string hint) {
  if (diagnostics_.size() == most_kept) {
    ++left_out_;
    return;
  }
  diagnostics_.push_back(located(origin, std::move(message), std::move(hint)));
}

void Reader::bad_value(const Origin& origin, std::string message, std::string hint) {
  plain(origin, std::move(message), std::move(hint));
  reported_keys_[entry_].insert(key_);
}

void Reader::unreadable(const Origin& origin, std::string message, std::string hint) {
  plain(origin, std::move(message), std::move(hint));
  unreadable_.insert(entry_);
  if (makes_masses(entry_.first) && decides_names(entry_.first, key_)) names_incomplete_ = true;
}

bool Reader::masses_readable() const {
  return std::ranges::none_of(unreadable_, [](const EntryId& entry) { return makes_masses(entry.first); });
}

bool Reader::model_readable() const {
  static constexpr std::array<std::string_view, 5> no_parts{"world", "solve", "camera", "look", "expect"};
  return std::ranges::all_of(unreadable_,
                             [](const EntryId& entry) { return is_one_of(entry.first, no_parts); });
}

bool Reader::follows_from_reported(const Problem& problem) const {
  const EntryId id{problem.section, problem.index};
  if (unreadable_.contains(id)) return true;
  static constexpr std::array<std::string_view, 6> using_names{"link",  "tie",   "load",
                                                               "angle", "hinge", "cone"};
  if (names_incomplete_ && is_one_of(problem.section, using_names)) return true;
  const auto reported = reported_keys_.find(id);
  if (reported == reported_keys_.end()) return false;
  return problem.key.empty() || reported->second.contains(problem.key.substr(0, problem.key.find('.')));
}

}  // namespace taut
