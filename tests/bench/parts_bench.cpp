// What each part of a scene costs a step of xpbd: a sheet of 64 × 64 masses that has every part there is, the
// same without one part at a time, with one part alone, with none, and that without the third dimension. What
// a scene lacks costs nothing: "nothing" is the plain kernel.
#include <benchmark/benchmark.h>

#include <string>

#include "bench_scenes.h"
#include "model/parts.h"

namespace {

using namespace taut;

Built sheet_with_everything() {
  LinkProperties soft;
  soft.stiffness = 1e4;
  soft.damping = 0.1;
  soft.break_stretch = 1e6;
  SheetSpec cloth;
  cloth.name = "cloth";
  cloth.rows = cloth.columns = 64;
  cloth.from = {0.0, 2.0, 0.0};
  cloth.to = {1.0, 2.0, 0.0};
  cloth.down = {0.0, -1.0, 0.0};
  cloth.pinned = {"top-left", "top-right"};
  cloth.properties = soft;
  cloth.diagonals = soft;
  MassSpec odd;  // another mass than the sheet's, and a pin that moves
  odd.name = "odd";
  odd.position = {3.0, 2.0, 0.0};
  odd.mass = 7.0;
  MassSpec hand = odd;
  hand.name = "hand";
  hand.position = {4.0, 2.0, 0.0};
  hand.pinned = true;
  hand.motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 3.0, 0.0};
  LoadSpec load;
  load.masses = {"cloth.63.*"};
  load.force = {0.0, -0.01, 0.0};
  load.to = 1.0;
  Description description;
  description.gravity = {0.0, -9.81, 1e-9};  // just off the plane
  description.drag = 0.1;
  description.planes = {PlaneSpec{}};
  description.sheets = {cloth};
  description.masses = {odd, hand};
  description.loads = {load};
  return bench::build_valid(description);
}

void steps(benchmark::State& run, const Model& model, const State& start) {
  constexpr double rate = 2400.0;
  const Settings how = complete_settings(bench::settings("xpbd", rate));
  Run moving(model, start, how);
  moving.step();  // what a method makes once
  for (auto round : run) moving.step();
  if (moving.ended()) run.SkipWithError("a step was not solved");
}

// Every part but one removed, in space or in the plane.
void plain_steps(benchmark::State& run, std::string_view but, bool in_plane) {
  Built built = sheet_with_everything();
  for (const Part& part : model_parts())
    if (part.name != but) part.remove(built.model);
  if (in_plane) built.model.gravity.z() = 0.0;
  steps(run, built.model, built.start);
}

[[maybe_unused]] const bool registered = [] {
  benchmark::RegisterBenchmark("everything", [](benchmark::State& run) {
    const Built built = sheet_with_everything();
    steps(run, built.model, built.start);
  });
  for (const Part& part : model_parts())
    benchmark::RegisterBenchmark(("without " + std::string(part.name)).c_str(),
                                 [&part](benchmark::State& run) {
                                   Built built = sheet_with_everything();
                                   part.remove(built.model);
                                   steps(run, built.model, built.start);
                                 });
  for (const Part& part : model_parts())
    benchmark::RegisterBenchmark(("only " + std::string(part.name)).c_str(), plain_steps, part.name, false);
  benchmark::RegisterBenchmark("nothing", plain_steps, "", false);
  benchmark::RegisterBenchmark("nothing, in a plane", plain_steps, "", true);
  return true;
}();

}  // namespace
