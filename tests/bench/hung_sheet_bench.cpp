// What a strain costs: a sheet of 64 × 64 masses and rigid links along its rows and columns, 1 m wide, no
// damping, let go level, 5 s, by methods and steps per second, on one thread: hung by its top row, or by two
// corners. The counters show one frame of 1/60 s and the largest strain at the end of any frame.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench_scenes.h"
#include "model/measures.h"

namespace {

using namespace taut;

Description hung_sheet(const std::vector<std::string>& pins) {
  SheetSpec cloth;
  cloth.name = "cloth";
  cloth.rows = cloth.columns = 64;
  cloth.from = {0.0, 2.0, 0.0};
  cloth.to = {1.0, 2.0, 0.0};
  cloth.down = {0.0, 0.0, 1.0};
  cloth.mass = 0.3;
  cloth.pinned = pins;
  Description description;
  description.sheets = {cloth};
  return description;
}

void five_seconds(benchmark::State& run, const char* method, const char* precision,
                  const std::vector<std::string>& pins) {
  constexpr int frames = 300;
  const Built built = bench::build_valid(hung_sheet(pins));
  Settings how = bench::settings(method, static_cast<double>(run.range(0)));
  if (*precision != '\0') how.values["precision"] = std::string(precision);
  how = complete_settings(how);
  double strain = 0.0;
  for (auto round : run) {
    Run moving(built.model, built.start, how);
    for (int frame = 0; frame < frames; ++frame) {
      for (std::int64_t step = 0; step < run.range(0) / 60; ++step) moving.step();
      run.PauseTiming();
      strain = std::max(strain, link_strain(built.model, moving.state()).largest);
      run.ResumeTiming();
    }
    if (moving.ended()) run.SkipWithError("a step was not solved");
  }
  run.counters["s/frame"] = benchmark::Counter(static_cast<double>(run.iterations()) * frames,
                                               benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  run.counters["max strain"] = strain;
}

#define HUNG_SHEET(label, ...)                        \
  BENCHMARK_CAPTURE(five_seconds, label, __VA_ARGS__) \
      ->ArgName("steps/s")                            \
      ->Unit(benchmark::kMillisecond)                 \
      ->Iterations(1)
HUNG_SHEET(by_the_top_row_xpbd, "xpbd", "", {"top"})->RangeMultiplier(2)->Range(960, 15360);
HUNG_SHEET(by_the_top_row_xpbd_single, "xpbd", "single", {"top"})->RangeMultiplier(2)->Range(960, 15360);
HUNG_SHEET(by_the_top_row_newton, "newton", "", {"top"})->Arg(60);
HUNG_SHEET(by_two_corners_xpbd, "xpbd", "", {"top-left", "top-right"})->RangeMultiplier(2)->Range(960, 30720);
HUNG_SHEET(by_two_corners_newton, "newton", "", {"top-left", "top-right"})->Arg(60);

}  // namespace
