#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace taut {

/// What a command line asks for; gives the exit status. Empty until a verb was recognised.
using Action = std::function<int()>;

// One function per verb, each in a file of its own: adds the verb with its flags and its help, and sets the
// action when the verb is used.
void add_render(CLI::App& program, Action& action);
void add_compare(CLI::App& program, Action& action);
void add_still(CLI::App& program, Action& action);
void add_strip(CLI::App& program, Action& action);
void add_check(CLI::App& program, Action& action);
void add_chart(CLI::App& program, Action& action);
void add_export(CLI::App& program, Action& action);
void add_sag(CLI::App& program, Action& action);
void add_stability(CLI::App& program, Action& action);
void add_list(CLI::App& program, Action& action);

}  // namespace taut
