#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completions.h"

namespace taut {
namespace {

// fish reads a backslash before a quote or a backslash within single quotes.
std::string fish_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : text) {
    if (letter == '\'' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + "'";
}

// What follows `complete` for a value: the words, or that it is a file.
std::string completed_in_fish(const FlagFacts& flag) {
  const auto one_of = [&](std::string_view words) {
    return flag.takes_list ? fmt::format(" -f -a {}", fish_quoted(fmt::format("(__fish_append , {})", words)))
                           : fmt::format(" -f -a {}", fish_quoted(words));
  };
  if (!flag.words.empty()) return one_of(fmt::format("{}", fmt::join(flag.words, " ")));
  switch (flag.kind) {
    case ValueKind::file:
      return " -F";
    case ValueKind::folder:
      return " -f -a '(__fish_complete_directories)'";
    case ValueKind::scene:
      return " -f -a '(taut generate words scenes 2>/dev/null; __fish_complete_suffix .toml)'";
    case ValueKind::change:
      return " -f -a '(taut generate words keys -- (commandline -opc)[3] 2>/dev/null)'";
    case ValueKind::method:
      return one_of(method_words());
    case ValueKind::text:
      break;
  }
  return " -f";
}

std::string fish_flag(const FlagFacts& flag) {
  if (flag.argument) return completed_in_fish(flag);
  std::string words;
  for (const std::string& name : flag.names)
    words += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                    : fmt::format(" -s {}", name.substr(1));
  if (flag.takes_value) words += " -r" + completed_in_fish(flag);
  return words + fmt::format(" -d {}", fish_quoted(flag.help));
}

}  // namespace

std::string fish_completions(const ProgramFacts& program) {
  std::string text = fmt::format(
      "# Completions of {0} for fish, made by `{0} generate completions fish`.\n\ncomplete -c {0} -f\n",
      program.name);
  for (const FlagFacts& flag : program.flags)
    text += fmt::format("complete -c {} -n __fish_use_subcommand{}\n", program.name, fish_flag(flag));
  for (const VerbFacts& verb : program.verbs)
    text += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d {}\n", program.name, verb.name,
                        fish_quoted(verb.help));
  for (const VerbFacts& verb : program.verbs)
    for (const FlagFacts& flag : verb.flags)
      text += fmt::format("complete -c {} -n '__fish_seen_subcommand_from {}'{}\n", program.name, verb.name,
                          fish_flag(flag));
  return text;
}

}  // namespace taut
