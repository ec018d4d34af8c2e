// The curtain of 64 × 64 masses, drawn open and shut for 10 s, by the methods that take it: of rigid links
// alone, and as in scenes/curtain.toml, where most of its links are soft; and the sag to
// which newton and converged xpbd settle with more drag, which must agree to 1e-4 of its height of 2.2 m.
#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "model/measures.h"
#include "scene/scene.h"

namespace {

using namespace taut;

Description curtain(double drag) {
  SheetSpec cloth;
  cloth.name = "cloth";
  cloth.rows = cloth.columns = 64;
  cloth.from = {-1.2, 2.5, 0.0};
  cloth.to = {1.2, 2.5, 0.0};
  cloth.down = {0.0, -2.2, 0.0};
  cloth.mass = 1.6;
  cloth.fullness = 1.67;
  cloth.hooks.every = 9;
  Description description;
  description.drag = drag;
  description.sheets = {cloth};
  return description;
}

void run_curtain(benchmark::State& run, const Model& model, const State& start, const Settings& how,
                 double duration) {
  const double rate = how.number("steps_per_second");
  State state;
  StepReport report;
  for (auto round : run) {
    state = start;
    report = bench::simulate_all(model, state, how, std::llround(duration * rate));
  }
  run.counters["sag (m)"] = sag(model, state);
  run.counters["speed (m/s)"] = fastest_speed(state);
  run.counters["strain"] = link_strain(model, state).largest;
  run.counters["halvings"] = static_cast<double>(report.halvings);
  const double steps = duration * rate;
  run.counters["rounds/step"] = static_cast<double>(report.rounds) / steps;
  run.counters["factors/step"] = static_cast<double>(report.factorisations) / steps;
  run.counters["solves/link/step"] =
      static_cast<double>(report.link_solves) / (steps * static_cast<double>(model.links.size()));
}

void drawn(benchmark::State& run, const char* method, double steps_per_second) {
  Description description = curtain(0.8);
  description.sheets[0].hooks.draw = {{0.0, 1.0}, {0.5, 1.0}, {3.0, 0.35}, {3.8, 0.35}, {6.3, 1.0}};
  const Built built = bench::build_valid(description);
  run_curtain(run, built.model, built.start, bench::settings(method, steps_per_second), 10.0);
}
BENCHMARK_CAPTURE(drawn, xpbd_1200, "xpbd", 1200.0)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(drawn, newton_240, "newton", 240.0)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(drawn, rattle_960, "rattle", 960.0)->Unit(benchmark::kMillisecond)->Iterations(1);

void scene_curtain(benchmark::State& run, const char* method, double steps_per_second) {
  const Scene scene = load_scene(TAUT_SCENE_FOLDER "/curtain.toml");
  run_curtain(run, scene.model, scene.start, bench::settings(method, steps_per_second), scene.duration);
}
BENCHMARK_CAPTURE(scene_curtain, xpbd_1200, "xpbd", 1200.0)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(scene_curtain, newton_240, "newton", 240.0)->Unit(benchmark::kMillisecond)->Iterations(1);

void settled(benchmark::State& run, const char* method, double steps_per_second, double passes) {
  Settings how = bench::settings(method, steps_per_second);
  if (passes > 0.0) how.values["passes"] = passes;
  const Built built = bench::build_valid(curtain(4.0));
  run_curtain(run, built.model, built.start, how, 10.0);
}
BENCHMARK_CAPTURE(settled, newton_240, "newton", 240.0, 0.0)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(settled, xpbd_2400_passes_50, "xpbd", 2400.0, 50.0)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
