#include "usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/nearest.h"

namespace taut {
namespace {

std::string unknown(std::string_view kind, const std::string& word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string_view nearest = nearest_name(word, names);
  return fmt::format("there is no {} \"{}\"{}", kind, word,
                     nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest));
}

std::string problem(const Misuse& misuse) {
  // A mistyped flag is the cause even where the parser stumbled over what came of it.
  const auto flag =
      std::ranges::find_if(misuse.left_over, [](const std::string& word) { return word.starts_with('-'); });
  if (flag != misuse.left_over.end()) return unknown("flag", flag->substr(0, flag->find('=')), misuse.flags);
  if (misuse.left_over.empty()) return misuse.complaint;
  if (misuse.verb.empty()) return unknown("verb", misuse.left_over.front(), misuse.verbs);
  return fmt::format("\"{}\" is one word too many", misuse.left_over.front());
}

}  // namespace

std::string usage_problem(const Misuse& misuse) {
  const std::string help = misuse.verb.empty() ? "taut --help" : fmt::format("taut {} --help", misuse.verb);
  return fmt::format("{}\nSee {}.", problem(misuse), help);
}

}  // namespace taut
