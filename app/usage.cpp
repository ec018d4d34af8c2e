#include "usage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "base/nearest.h"

namespace taut {
namespace {

using Words = std::vector<std::string>;

std::string unknown(std::string_view kind, const std::string& word, const Words& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string_view nearest = nearest_name(word, names);
  return fmt::format("there is no {} \"{}\"{}", kind, word,
                     nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest));
}

// Whoever gave a flag to the wrong verb: which ones have it.
std::string verbs_with(const std::string& flag, const Misuse& misuse) {
  Words verbs;
  for (const auto& [verb, flags] : misuse.flags)
    if (std::ranges::find(flags, flag) != flags.end()) verbs.push_back(fmt::format("taut {}", verb));
  if (verbs.empty()) return {};
  return fmt::format("{} {} it", fmt::join(verbs, ", "), verbs.size() == 1 ? "has" : "have");
}

std::string unknown_flag(const std::string& flag, const Misuse& misuse) {
  const auto own = misuse.flags.find(misuse.verb);
  if (const std::string others = verbs_with(flag, misuse); own != misuse.flags.end() && !others.empty())
    return fmt::format("taut {} has no flag \"{}\"; {}", misuse.verb, flag, others);
  return unknown("flag", flag, own == misuse.flags.end() ? Words() : own->second);
}

std::string unknown_verb(const std::string& verb, const Misuse& misuse) {
  Words verbs;
  for (const auto& [name, flags] : misuse.flags) verbs.push_back(name);
  return unknown("verb", verb, verbs);
}

// A change that stands alone: it may have been taken for a scene, and the scene then be the word too many.
const std::string* lone_change(const Misuse& misuse) {
  for (const Words* words : {&misuse.left_over, &misuse.arguments})
    for (const std::string& word : *words)
      if (word.find('=') != std::string::npos) return &word;
  return nullptr;
}

std::string problem(const Misuse& misuse) {
  // A mistyped flag is the cause even where the parser stumbled over what came of it.
  const auto flag =
      std::ranges::find_if(misuse.left_over, [](const std::string& word) { return word.starts_with('-'); });
  if (flag != misuse.left_over.end()) return unknown_flag(flag->substr(0, flag->find('=')), misuse);
  if (misuse.left_over.empty()) return misuse.complaint;
  if (misuse.verb.empty()) return unknown_verb(misuse.left_over.front(), misuse);
  if (const std::string* change = lone_change(misuse))
    return fmt::format("\"{}\" is one word too many; {}", *change, set_hint(*change));
  return fmt::format("\"{}\" is one word too many", misuse.left_over.front());
}

}  // namespace

std::string set_hint(const std::string& change) {
  return fmt::format("every change takes a --set of its own: --set {}", change);
}

std::string with_help(const std::string& complaint, const std::string& verb) {
  return fmt::format("{}\nSee {}.", complaint,
                     verb.empty() ? "taut --help" : fmt::format("taut {} --help", verb));
}

std::string usage_problem(const Misuse& misuse) {
  return with_help(problem(misuse), misuse.verb);
}

}  // namespace taut
