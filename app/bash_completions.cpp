#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <vector>

#include "completions.h"

namespace taut {
namespace {

// What the functions below share: `cur` is the word to be completed, COMPREPLY what it may become.
constexpr std::string_view bash_functions = R"shell(_taut_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur")
}

# Words with commas between them.
_taut_list() {
  local before=
  [[ $cur == *,* ]] && before=${cur%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$1" -- "${cur##*,}")
  compopt -o nospace 2>/dev/null
}

_taut_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -- "$cur")
}

_taut_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur")
}

# Keys that --set takes: of the scene that comes first after the verb, else of any.
_taut_keys() {
  compopt -o nospace 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]/#\~/$HOME}" generate words keys -- "${COMP_WORDS[2]}" 2>/dev/null)" -- "$cur")
}

# Scenes by name, and scene files.
_taut_scenes() {
  compopt -o filenames 2>/dev/null
  local IFS=$'\n'
  mapfile -t COMPREPLY < <(
    compgen -W "$("${COMP_WORDS[0]/#\~/$HOME}" generate words scenes 2>/dev/null)" -- "$cur"
    compgen -d -- "$cur"
    compgen -f -X '!*.toml' -- "$cur"
  )
}
)shell";

// The call that completes a value; empty where any text will do.
std::string completed_in_bash(const FlagFacts& flag) {
  if (!flag.words.empty())
    return fmt::format("{} {}", flag.takes_list ? "_taut_list" : "_taut_words",
                       shell_quoted(fmt::format("{}", fmt::join(flag.words, " "))));
  switch (flag.kind) {
    case ValueKind::file:
      return "_taut_files";
    case ValueKind::folder:
      return "_taut_folders";
    case ValueKind::scene:
      return "_taut_scenes";
    case ValueKind::change:
      return "_taut_keys";
    case ValueKind::method:
      return fmt::format("{} {}", flag.takes_list ? "_taut_list" : "_taut_words",
                         shell_quoted(method_words()));
    case ValueKind::text:
      break;
  }
  return ":";
}

// Values after flags, those that are completed alike together: the case's patterns by what is called.
std::map<std::string, std::vector<std::string>> bash_values(const ProgramFacts& program) {
  std::map<std::string, std::vector<std::string>> patterns;
  for (const VerbFacts& verb : program.verbs)
    for (const FlagFacts& flag : verb.flags)
      if (flag.takes_value && !flag.argument)
        for (const std::string& name : flag.names)
          patterns[completed_in_bash(flag)].push_back(fmt::format("\"{} {}\"", verb.name, name));
  return patterns;
}

std::string bash_verb(const VerbFacts& verb) {
  std::vector<std::string> names;
  std::string argument = ":";
  for (const FlagFacts& flag : verb.flags) {
    if (flag.argument)
      argument = completed_in_bash(flag);
    else
      names.insert(names.end(), flag.names.begin(), flag.names.end());
  }
  return fmt::format("    {})\n      if [[ $cur == -* ]]; then _taut_words {}; else {}; fi\n      ;;\n",
                     verb.name, shell_quoted(fmt::format("{}", fmt::join(names, " "))), argument);
}

}  // namespace

std::string bash_completions(const ProgramFacts& program) {
  std::vector<std::string> verbs, flags;
  for (const VerbFacts& verb : program.verbs) verbs.push_back(verb.name);
  for (const FlagFacts& flag : program.flags) flags.insert(flags.end(), flag.names.begin(), flag.names.end());
  std::string text =
      fmt::format("# Completions of {0} for bash, made by `{0} generate completions bash`.\n\n{1}\n",
                  program.name, bash_functions);
  text += fmt::format(R"shell(_taut() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} verb= word
  # bash takes = for a word of its own.
  if [[ $cur == '=' ]]; then
    cur=
  elif [[ $before == '=' ]]; then
    before=${{COMP_WORDS[COMP_CWORD - 2]}}
    [[ $before == -* ]] || before=value  # of a key
  fi
  COMPREPLY=()
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD - 1}}"; do
    case $word in
      {}) verb=$word && break ;;
    esac
  done
  case "$verb $before" in
    *" value") return ;;
)shell",
                      fmt::join(verbs, " | "));
  for (const auto& [call, patterns] : bash_values(program))
    text += fmt::format("    {})\n      {}\n      return\n      ;;\n", fmt::join(patterns, " | "), call);
  text += "  esac\n  case $verb in\n";
  for (const VerbFacts& verb : program.verbs) text += bash_verb(verb);
  text += fmt::format(
      "    *) if [[ $cur == -* ]]; then _taut_words {}; else _taut_words {}; fi ;;\n  esac\n}}\n\n",
      shell_quoted(fmt::format("{}", fmt::join(flags, " "))),
      shell_quoted(fmt::format("{}", fmt::join(verbs, " "))));
  return text + fmt::format("complete -F _taut {}\n", program.name);
}

}  // namespace taut
