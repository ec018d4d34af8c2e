#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completions.h"

namespace taut {
namespace {

constexpr std::string_view zsh_functions = R"shell(# Scenes by name, and scene files.
_taut_scenes() {
  local -a scenes
  scenes=("${(@f)$(taut generate words scenes 2>/dev/null)}")
  _alternative 'scenes:scene:compadd -a scenes' 'files:scene file:_files -g "*.toml"'
}

# Keys that --set takes: of the scene that comes first after the verb, else of any.
_taut_keys() {
  local -a keys
  keys=("${(@f)$(taut generate words keys -- "$words[2]" 2>/dev/null)}")
  compadd -S '' -a keys
}
)shell";

// Colons and brackets mean something in a specification of _arguments.
std::string in_specification(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == ':' || letter == '[' || letter == ']' || letter == '\\') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string completed_in_zsh(const FlagFacts& flag) {
  const auto one_of = [&](std::string_view words) {
    return flag.takes_list ? fmt::format("_sequence compadd - {}", words) : fmt::format("({})", words);
  };
  if (!flag.words.empty()) return one_of(fmt::format("{}", fmt::join(flag.words, " ")));
  switch (flag.kind) {
    case ValueKind::file:
      return "_files";
    case ValueKind::folder:
      return "_files -/";
    case ValueKind::scene:
      return "_taut_scenes";
    case ValueKind::change:
      return "_taut_keys";
    case ValueKind::method:
      return one_of(method_words());
    case ValueKind::text:
      break;
  }
  return " ";
}

std::string zsh_flag(const FlagFacts& flag) {
  const std::string action = completed_in_zsh(flag);
  if (flag.argument)
    return shell_quoted(
        fmt::format("{}:{}:{}", flag.takes_several ? "*" : "", in_specification(flag.names.front()), action));
  std::string specifications;
  for (const std::string& name : flag.names)
    specifications += fmt::format(
        "{}{}", specifications.empty() ? "" : " ",
        shell_quoted(fmt::format("*{}{}[{}]{}", name, flag.takes_value && name.starts_with("--") ? "=" : "",
                                 in_specification(flag.help),
                                 flag.takes_value ? fmt::format(":value:{}", action) : "")));
  return specifications;
}

}  // namespace

std::string zsh_completions(const ProgramFacts& program) {
  std::string text = fmt::format(
      "#compdef {0}\n# Completions of {0} for zsh, made by `{0} generate completions zsh`.\n\n{1}\n",
      program.name, zsh_functions);
  text += "_taut() {\n  local -a verbs\n  verbs=(\n";
  for (const VerbFacts& verb : program.verbs)
    text +=
        fmt::format("    {}\n", shell_quoted(fmt::format("{}:{}", verb.name, in_specification(verb.help))));
  text += "  )\n  if (( CURRENT == 2 )); then\n    _describe -t verbs verb verbs\n";
  text += "    _arguments";
  for (const FlagFacts& flag : program.flags) text += " " + zsh_flag(flag);
  text += "\n    return\n  fi\n  local verb=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $verb in\n";
  for (const VerbFacts& verb : program.verbs) {
    text += fmt::format("    {})\n      _arguments -S", verb.name);
    for (const FlagFacts& flag : verb.flags) text += " \\\n        " + zsh_flag(flag);
    text += "\n      ;;\n";
  }
  return text + "  esac\n}\n\nif [[ $funcstack[1] == _taut ]]; then\n  _taut \"$@\"\nelse\n  compdef _taut " +
         program.name + "\nfi\n";
}

}  // namespace taut
