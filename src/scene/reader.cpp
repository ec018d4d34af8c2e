#include "reader.h"

#include <fmt/format.h>

namespace taut {
namespace {

constexpr std::size_t most_kept = 10'000;

}  // namespace

void Reader::begin_entry(std::string_view section, std::size_t index) {
  entry_ = {std::string(section), index};
  key_.clear();
}

std::string Reader::home_hint(std::string_view key) const {
  std::string labels;
  const auto [begin, end] = homes_.equal_range(key);
  for (auto home = begin; home != end; ++home)
    labels += fmt::format("{}{}", labels.empty() ? "" : ", ", home->second);
  return labels.empty() ? labels : fmt::format("{} is a key of {}", in_quotes(key), labels);
}

void Reader::plain(const Origin& origin, std::string message, std::string hint) {
  if (diagnostics_.size() == most_kept) {
    ++left_out_;
    return;
  }
  const bool in_file = origin.change < 0;
  diagnostics_.push_back({in_file ? file_ : changes_[static_cast<std::size_t>(origin.change)],
                          in_file ? origin.line : 0, in_file ? origin.column : 0, std::move(message),
                          std::move(hint)});
}

void Reader::bad_value(const Origin& origin, std::string message, std::string hint) {
  plain(origin, std::move(message), std::move(hint));
  reported_keys_[entry_].insert(key_);
}

void Reader::unreadable(const Origin& origin, std::string message, std::string hint) {
  plain(origin, std::move(message), std::move(hint));
  unreadable_.insert(entry_);
  const std::string& section = entry_.first;
  // An empty section is the top level: an unknown section may have been meant to hold masses.
  if (section.empty() || section == "mass" || section == "chain" || section == "sheet")
    names_incomplete_ = true;
}

bool Reader::follows_from_reported(const Problem& problem) const {
  const EntryId id{problem.section, problem.index};
  if (unreadable_.contains(id)) return true;
  if (names_incomplete_ && (problem.section == "link" || problem.section == "load")) return true;
  const auto reported = reported_keys_.find(id);
  if (reported == reported_keys_.end()) return false;
  return problem.key.empty() || reported->second.contains(problem.key.substr(0, problem.key.find('.')));
}

}  // namespace taut
