#include "completions.h"

#include <fmt/format.h>

#include <array>

#include "methods/registry.h"

namespace taut {

std::span<const std::string_view> completed_shells() {
  static constexpr std::array<std::string_view, 3> shells{"bash", "zsh", "fish"};
  return shells;
}

std::string completions(const ProgramFacts& program, std::string_view shell) {
  if (shell == "bash") return bash_completions(program);
  return shell == "zsh" ? zsh_completions(program) : fish_completions(program);
}

std::string method_words() {
  std::string words;
  for (const Method& method : all_methods())
    words += fmt::format("{}{}", words.empty() ? "" : " ", method.name);
  return words;
}

std::string shell_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : text) {
    if (letter == '\'')
      quoted += "'\\''";
    else
      quoted += letter;
  }
  return quoted + "'";
}

}  // namespace taut
