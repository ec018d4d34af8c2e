// Hard chains with newton, released level, 5 s: 1000 masses over 1 m with the last one 100 times heavier, and
// 1000 links of 10 mm of equal masses. Time is that of all 300 frames of 1/60 s; the counters show one
// frame's, the largest strain at the end of any frame, and the halvings.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "bench_scenes.h"
#include "model/measures.h"

namespace {

using namespace taut;

void five_seconds(benchmark::State& run, const Description& description) {
  constexpr int frames = 300;
  const Built built = bench::build_valid(description);
  const Settings how = bench::settings("newton", static_cast<double>(run.range(0)));
  const std::int64_t steps_a_frame = run.range(0) / 60;
  double strain = 0.0;
  StepReport total;
  for (auto round : run) {
    Run moving(built.model, built.start, how);
    for (int frame = 0; frame < frames; ++frame) {
      for (std::int64_t step = 0; step < steps_a_frame; ++step) moving.step();
      strain = std::max(strain, link_strain(built.model, moving.state()).largest);
    }
    if (moving.ended()) run.SkipWithError("a step was not solved");
    total.add(moving.report().counts);
  }
  run.counters["s/frame"] = benchmark::Counter(static_cast<double>(run.iterations()) * frames,
                                               benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  run.counters["max strain"] = strain;
  run.counters["halvings"] = static_cast<double>(total.halvings) / static_cast<double>(run.iterations());
  run.counters["rounds"] = static_cast<double>(total.rounds) / static_cast<double>(run.iterations());
}

void heavy_tip(benchmark::State& run) {
  five_seconds(run, bench::level_chain(999, 1.0 / 999.0, 100.0));
}
BENCHMARK(heavy_tip)->Arg(60)->Arg(240)->Arg(960)->Unit(benchmark::kMillisecond)->Iterations(1);

void thousand_links(benchmark::State& run) {
  five_seconds(run, bench::level_chain(1000, 0.01));
}
BENCHMARK(thousand_links)->Arg(60)->Arg(240)->Arg(960)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
