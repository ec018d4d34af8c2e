// What dop853 costs a link and evaluation of the equations of motion, everything in: stages, step control,
// projection onto the links. Chains, and a net of rigid links hung by a corner.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench_scenes.h"

namespace {

using namespace taut;

constexpr std::int64_t steps_at_once = 4;

void per_evaluation(benchmark::State& run, const Description& description, int threads = 1) {
  const Built built = bench::build_valid(description);
  Run motion(built.model, built.start, complete_settings({"dop853", {{"tolerance", 1e-6}}}), {},
             {std::make_shared<Workers>(threads)});
  for (int step = 0; step < 8; ++step) motion.step();  // until steps are as long as they may be
  const std::int64_t attempts_before = motion.report().counts.rounds;
  std::int64_t steps = 0;
  for (auto round : run)
    for (std::int64_t step = 0; step < steps_at_once; ++step, ++steps)
      if (!motion.step()) throw std::runtime_error(motion.failure());
  // Eleven stages that every attempt at a step works out, and the end of those that are made; what projection
  // solves is in the time, but is no evaluation.
  const std::int64_t attempts = motion.report().counts.rounds - attempts_before;
  const auto evaluations = static_cast<double>(11 * attempts + steps);
  const auto links = static_cast<double>(built.model.links.size());
  // With SI prefixes: "12n" are 12 ns.
  run.counters["s/link/evaluation"] =
      benchmark::Counter(evaluations * links, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void chain_on_threads(benchmark::State& run, int threads) {
  per_evaluation(run, bench::swinging_chain(static_cast<int>(run.range(0))), threads);
}
void chain(benchmark::State& run) {
  chain_on_threads(run, 1);
}
BENCHMARK(chain)->Arg(20)->RangeMultiplier(10)->Range(100, 100000)->Unit(benchmark::kMillisecond);
void chain_on_2_threads(benchmark::State& run) {
  chain_on_threads(run, 2);
}
BENCHMARK(chain_on_2_threads)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void net(benchmark::State& run) {
  per_evaluation(run, bench::hung_net(static_cast<int>(run.range(0))));
}
BENCHMARK(net)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);

}  // namespace
