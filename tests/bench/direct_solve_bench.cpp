// Cost of a step of the direct methods per link of a chain, from 100 to 100,000 links: flat, because their
// elimination along a chain is O(n). All chains are 1 m links that swing the same way at first, so a step
// takes as many rounds at every length; the counter shows them.
#include <benchmark/benchmark.h>

#include "bench_scenes.h"

namespace {

using namespace taut;

// One stepper that goes on, so that only steps are timed.
void step_of_a_chain(benchmark::State& run, const char* name) {
  const auto links = static_cast<int>(run.range(0));
  const Built built = bench::build_valid(bench::level_chain(links, 1.0));
  const Settings how = complete_settings(bench::settings(name, 2400.0));
  Run moving(built.model, built.start, how);
  moving.step();  // what a method makes once
  for (auto round : run) moving.step();
  const StepReport& total = moving.report().counts;
  if (moving.ended()) run.SkipWithError("a step was not solved");
  const auto steps = static_cast<double>(run.iterations());
  run.counters["s/link"] =
      benchmark::Counter(steps * links, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  run.counters["rounds/step"] = static_cast<double>(total.rounds) / static_cast<double>(moving.steps());
}
BENCHMARK_CAPTURE(step_of_a_chain, rattle, "rattle")
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->Iterations(200);
BENCHMARK_CAPTURE(step_of_a_chain, newton, "newton")
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->Iterations(200);

}  // namespace
