// IFToMM benchmark A01 with rattle and dop853: a pendulum of 1 kg and 1 m released level, 10 s. The published
// bound on the energy error is 5e-5 J; the counter shows the largest error at any step. Cheapest that meets
// the bound wins.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "bench_scenes.h"
#include "model/measures.h"

namespace {

using namespace taut;

constexpr double duration = 10.0;  // s

Built pendulum() {
  Description description;
  MassSpec hook, bob;
  hook.name = "hook";
  hook.pinned = true;
  bob.name = "bob";
  bob.position = {1.0, 0.0, 0.0};
  description.masses = {hook, bob};
  description.links = {LinkSpec{"hook", "bob", 1.0, {}}};
  return bench::build_valid(description);
}

double largest_energy_error(const Built& built, const Settings& how, std::int64_t steps) {
  const double at_start = energy(built.model, built.start).total();
  State state = built.start;
  double largest = 0.0;
  for (std::int64_t step = 0; step < steps; ++step) {
    bench::simulate_all(built.model, state, how, 1);
    largest = std::max(largest, std::abs(energy(built.model, state).total() - at_start));
  }
  return largest;
}

void ten_seconds(benchmark::State& run, const char* order) {
  const Built built = pendulum();
  Settings how = bench::settings("rattle", static_cast<double>(run.range(0)));
  how.values["order"] = std::string(order);
  const std::int64_t steps = std::llround(duration * static_cast<double>(run.range(0)));
  for (auto round : run) {
    State state = built.start;
    bench::simulate_all(built.model, state, how, steps);
    benchmark::DoNotOptimize(state.position.x.data());
  }
  run.counters["energy error (J)"] = largest_energy_error(built, how, steps);
}
BENCHMARK_CAPTURE(ten_seconds, order_2, "2")->Arg(850)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ten_seconds, order_4, "4")
    ->Arg(60)
    ->Arg(70)
    ->Arg(80)
    ->Arg(120)
    ->Unit(benchmark::kMillisecond);

// The tolerance is 10^(−n/2) m.
void dop853(benchmark::State& run) {
  const Built built = pendulum();
  const Settings how = complete_settings(
      {"dop853", {{"tolerance", std::pow(10.0, -0.5 * static_cast<double>(run.range(0)))}}});
  for (auto round : run) {
    Run motion(built.model, built.start, how);
    benchmark::DoNotOptimize(motion.at(duration)->position.x.data());
  }
  const double at_start = energy(built.model, built.start).total();
  double largest = 0.0;
  for (Run motion(built.model, built.start, how); motion.state().time < duration; motion.step())
    largest = std::max(largest, std::abs(energy(built.model, motion.state()).total() - at_start));
  run.counters["energy error (J)"] = largest;
}
BENCHMARK(dop853)->DenseRange(11, 14)->Unit(benchmark::kMillisecond);

}  // namespace
