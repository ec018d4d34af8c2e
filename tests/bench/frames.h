#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>

#include "bench_scenes.h"
#include "model/measures.h"

namespace taut::bench {

/// Five seconds by a method, in frames of 1/60 s, each time from the start; the counters show one frame's
/// time and the largest strain at the end of any frame. Returns the counts of all of it.
inline StepReport five_seconds(benchmark::State& run, const Built& built, const Settings& how) {
  constexpr int frames = 300;
  const auto steps_a_frame = static_cast<std::int64_t>(how.steps_per_second() / 60.0);
  double strain = 0.0;
  StepReport total;
  for (auto round : run) {
    Run moving(built.model, built.start, how);
    for (int frame = 0; frame < frames; ++frame) {
      for (std::int64_t step = 0; step < steps_a_frame; ++step) moving.step();
      run.PauseTiming();
      strain = std::max(strain, link_strain(built.model, moving.state()).largest);
      run.ResumeTiming();
    }
    if (moving.ended()) run.SkipWithError("a step was not solved");
    total.add(moving.report().counts);
  }
  run.counters["s/frame"] = benchmark::Counter(static_cast<double>(run.iterations()) * frames,
                                               benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  run.counters["max strain"] = strain;
  return total;
}

}  // namespace taut::bench
