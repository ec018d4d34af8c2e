// What limits on angles cost: a chain that has none, and the same chain with one at every mass.
#include <benchmark/benchmark.h>

#include "bench_scenes.h"

namespace {

using namespace taut;

void step_of_a_chain(benchmark::State& run, const char* name) {
  constexpr int links = 200;
  constexpr double rate = 2400.0;
  Description description = bench::level_chain(links, 0.01);
  for (int i = 1; i < links && run.range(0) != 0; ++i) {
    AngleSpec angle;
    for (const int mass : {i - 1, i, i + 1}) angle.masses.push_back("rope." + std::to_string(mass));
    angle.min = 160.0;
    description.angles.push_back(angle);
  }
  const Built built = bench::build_valid(description);
  Run moving(built.model, built.start, complete_settings(bench::settings(name, rate)));
  moving.step();  // what a method makes once
  for (auto round : run) moving.step();
  if (moving.ended()) run.SkipWithError("a step was not solved");
}
BENCHMARK_CAPTURE(step_of_a_chain, xpbd, "xpbd")->Arg(0)->Arg(1)->ArgName("limits");
BENCHMARK_CAPTURE(step_of_a_chain, verlet, "verlet")->Arg(0)->Arg(1)->ArgName("limits");

}  // namespace
