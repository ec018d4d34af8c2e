#include "usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/nearest.h"

namespace taut {
namespace {

const CLI::App& verb_in_use(const CLI::App& program) {
  const std::vector<CLI::App*> used = program.get_subcommands();
  return used.empty() ? program : *used.front();
}

std::vector<std::string> flags_of(const CLI::App& verb) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  return flags;
}

std::vector<std::string> verbs_of(const CLI::App& program) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : program.get_subcommands({})) verbs.push_back(verb->get_name());
  return verbs;
}

std::string unknown(std::string_view kind, const std::string& word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string_view nearest = nearest_name(word, names);
  return fmt::format("there is no {} \"{}\"{}", kind, word,
                     nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest));
}

}  // namespace

std::string usage_problem(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& verb = verb_in_use(program);
  const std::vector<std::string> left_over = verb.remaining();
  // A mistyped flag is the cause even where the parser stumbled over what came of it.
  const auto flag =
      std::ranges::find_if(left_over, [](const std::string& word) { return word.starts_with('-'); });
  if (flag != left_over.end()) return unknown("flag", flag->substr(0, flag->find('=')), flags_of(verb));
  if (left_over.empty()) return error.what();
  if (&verb == &program) return unknown("verb", left_over.front(), verbs_of(program));
  return fmt::format("\"{}\" is one word too many", left_over.front());
}

std::string help_hint(const CLI::App& program) {
  const CLI::App& verb = verb_in_use(program);
  return &verb == &program ? "taut --help" : fmt::format("taut {} --help", verb.get_name());
}

}  // namespace taut
