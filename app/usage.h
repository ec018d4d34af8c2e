#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace taut {

/// What is wrong with a command line, as a sentence: an unknown verb or flag with the nearest one there is,
/// or what the parser says.
std::string usage_problem(const CLI::App& program, const CLI::ParseError& error);

/// How a program's or verb's help is called, for the end of such a message.
std::string help_hint(const CLI::App& program);

}  // namespace taut
