#pragma once

namespace taut {

class CommandLine;

// One function per verb, each in a file of its own: adds the verb with its flags, its help and its action.
void add_render(CommandLine& program);
void add_compare(CommandLine& program);
void add_still(CommandLine& program);
void add_strip(CommandLine& program);
void add_check(CommandLine& program);
void add_chart(CommandLine& program);
void add_plot(CommandLine& program);
void add_export(CommandLine& program);
void add_sag(CommandLine& program);
void add_stability(CommandLine& program);
void add_bench(CommandLine& program);
void add_simulate(CommandLine& program);
void add_merge(CommandLine& program);
void add_verify(CommandLine& program);
void add_list(CommandLine& program);

}  // namespace taut
