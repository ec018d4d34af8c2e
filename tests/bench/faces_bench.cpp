// What a step costs where faces touch, by the number of triangles and of threads: a sheet that falls freely
// and flat, so that nothing is near; two that lie on each other on the ground, so that all of it is in
// contact; and the first without faces, for what the rest of a step takes.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench_scenes.h"
#include "model/faces.h"

namespace {

using namespace taut;

constexpr double rate = 1200.0, cell = 0.01, thickness = 0.003;  // 1/s, m, m

SheetSpec sheet_of(std::string name, std::int64_t triangles, const Vec3& corner) {
  SheetSpec sheet;
  sheet.name = std::move(name);
  const int cells = static_cast<int>(std::lround(std::sqrt(0.5 * static_cast<double>(triangles))));
  sheet.rows = sheet.columns = cells + 1;
  sheet.from = corner;
  sheet.to = corner + Vec3(cells * cell, 0.0, 0.0);
  sheet.down = {0.0, 0.0, cells * cell};
  sheet.mass = 0.2 * cells * cell * cells * cell;
  sheet.properties.stiffness = 500.0;
  sheet.diagonals = sheet.properties;
  sheet.faces = FacesSpec{thickness, 0.3, true};
  sheet.collides = true;
  return sheet;
}

void step(benchmark::State& run, const Description& description) {
  const Built built = bench::build_valid(description);
  Run moving(built.model, built.start, complete_settings(bench::settings("xpbd", rate)), {},
             {std::make_shared<Workers>(static_cast<int>(run.range(1)))});
  for (int i = 0; i < 20; ++i) moving.step();
  for (auto round : run) moving.step();
  if (moving.ended()) run.SkipWithError("a step was not solved");
  const auto triangles = static_cast<double>(built.model.triangles.size());
  run.counters["triangles"] = triangles;
  run.counters["s/triangle"] = benchmark::Counter(
      triangles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void falling(benchmark::State& run, bool faces) {
  Description description;
  description.sheets = {sheet_of("cloth", run.range(0), Vec3::Zero())};
  if (!faces) {
    description.sheets[0].faces.reset();
    description.sheets[0].collides = false;
  }
  step(run, description);
}

void lying_on_another(benchmark::State& run) {
  Description description;
  description.sheets = {sheet_of("lower", run.range(0) / 2, {0.0, 0.5 * thickness, 0.0}),
                        sheet_of("upper", run.range(0) / 2, {0.003, 1.5 * thickness, 0.004})};
  description.planes = {PlaneSpec{}};
  step(run, description);
}

#define SIZES                                      \
  ->ArgsProduct({{1000, 10'000, 100'000}, {1, 2}}) \
      ->ArgNames({"triangles", "threads"})         \
      ->UseRealTime()                              \
      ->MeasureProcessCPUTime()                    \
      ->Unit(benchmark::kMillisecond)
BENCHMARK_CAPTURE(falling, without_faces, false) SIZES;
BENCHMARK_CAPTURE(falling, with_faces, true) SIZES;
BENCHMARK(lying_on_another) SIZES;

}  // namespace
