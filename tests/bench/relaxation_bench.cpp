// The relaxation methods' cost per link and pass on square sheets hung by two corners, integration and all
// overhead in, one pass a step.
#include <benchmark/benchmark.h>

#include "bench_scenes.h"

namespace {

using namespace taut;

Built sheet(int size, bool diagonals) {
  SheetSpec cloth;
  cloth.name = "cloth";
  cloth.rows = cloth.columns = size;
  cloth.to = {1.0, 0.0, 0.0};
  cloth.down = {0.0, 0.0, 1.0};
  cloth.pinned = {"top-left", "top-right"};
  if (diagonals) cloth.diagonals = LinkProperties{};
  Description description;
  description.sheets = {cloth};
  return bench::build_valid(description);
}

void pass_over_a_sheet(benchmark::State& run, const char* name) {
  const Built built = sheet(static_cast<int>(run.range(0)), run.range(1) != 0);
  constexpr double rate = 2400.0;
  const Settings how = complete_settings(bench::settings(name, rate));
  Run moving(built.model, built.start, how);
  for (auto round : run) moving.step();
  const StepReport& total = moving.report().counts;
  if (moving.ended()) run.SkipWithError("a step was not solved");
  run.counters["s/link/pass"] = benchmark::Counter(static_cast<double>(total.link_solves),
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(pass_over_a_sheet, xpbd, "xpbd")
    ->ArgsProduct({{64, 256}, {0, 1}})
    ->ArgNames({"size", "diagonals"});
BENCHMARK_CAPTURE(pass_over_a_sheet, verlet, "verlet")
    ->ArgsProduct({{64, 256}, {0, 1}})
    ->ArgNames({"size", "diagonals"});

}  // namespace
