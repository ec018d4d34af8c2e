#pragma once

#include <span>
#include <string>
#include <string_view>

#include "command_line.h"

namespace taut {

/// The shells that completions can be made for.
std::span<const std::string_view> completed_shells();

/// The completions of a command line for one of completed_shells(), as a script that the shell reads. Names
/// of scenes it asks the program for.
std::string completions(const ProgramFacts& program, std::string_view shell);

// Of each shell, as completions() gives them.
std::string bash_completions(const ProgramFacts& program);
std::string zsh_completions(const ProgramFacts& program);
std::string fish_completions(const ProgramFacts& program);

/// All methods, as words with spaces between them.
std::string method_words();

/// A text between single quotes, as shells read it.
std::string shell_quoted(std::string_view text);

}  // namespace taut
