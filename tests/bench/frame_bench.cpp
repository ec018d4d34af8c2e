// What a frame takes from state to file, stage by stage, in processor time of all threads (Mesa's too): the
// showcases at 1280×720 standard, and ten bodies. Run it alone on the machine:
//
//   cmake --preset tested && cmake --build --preset tested --target frame_bench &&
//   build/tested/tests/bench/frame_bench
//
// `empty picture` has nothing but the sky, seen from another place each time: what a backdrop costs that
// can't be kept. `taut render … -v` has the same of a whole run, the film's encoder included.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "frames/painter.h"
#include "frames/picture_price.h"
#include "frames/settled_view.h"
#include "frames/simulation.h"
#include "output/png.h"
#include "scene/scene.h"

namespace {

struct Subject {
  const char* scene;
  double time;  // s, at which there is much to see
};

taut::PictureSettings standard() {
  taut::PictureSettings settings;
  settings.render = taut::render_settings_for(taut::Quality::standard);
  return settings;
}

taut::Scene scene_of(const Subject& subject) {
  taut::Scene scene =
      taut::load_scene(std::filesystem::path(TAUT_SCENE_FOLDER) / (std::string(subject.scene) + ".toml"));
  taut::settle_views({&scene, 1}, standard().render.size);
  return scene;
}

void shape(benchmark::State& run, Subject subject) {
  const taut::Scene scene = scene_of(subject);
  const taut::State state = *taut::Simulation(scene).at(subject.time);
  taut::Painter painter(scene, standard());
  for (auto round : run) benchmark::DoNotOptimize(painter.shape({&state}));
}

void draw(benchmark::State& run, Subject subject) {
  const taut::Scene scene = scene_of(subject);
  taut::Painter painter(scene, standard());
  const taut::State state = *taut::Simulation(scene).at(subject.time);
  const auto geometry = painter.shape({&state});
  for (auto round : run) {
    painter.submit(*geometry);
    benchmark::DoNotOptimize(painter.fetch());
  }
}

void finish(benchmark::State& run, Subject subject) {
  const taut::Scene scene = scene_of(subject);
  taut::Painter painter(scene, standard());
  const taut::State state = *taut::Simulation(scene).at(subject.time);
  painter.submit(*painter.shape({&state}));
  const auto layers = painter.fetch();
  for (auto round : run) benchmark::DoNotOptimize(taut::flatten(*layers));
}

void compress(benchmark::State& run, Subject subject) {
  const taut::Scene scene = scene_of(subject);
  const taut::Image image = taut::Painter(scene, standard()).draw(*taut::Simulation(scene).at(subject.time));
  for (auto round : run) benchmark::DoNotOptimize(taut::encode_png(image));
}

// All stages, one after another; the counter is what is foretold of them (ms).
void whole_picture(benchmark::State& run, Subject subject) {
  const taut::Scene scene = scene_of(subject);
  taut::Painter painter(scene, standard());
  const taut::State state = *taut::Simulation(scene).at(subject.time);
  for (auto round : run) benchmark::DoNotOptimize(taut::encode_png(painter.draw(state)));
  run.counters["foretold"] = 1e3 * taut::predicted_picture_seconds(scene.model, standard().render);
}

void empty_picture(benchmark::State& run) {
  taut::Scene scene = scene_of({"pendulum", 0.0});
  scene.look = {};
  scene.look.masses = scene.look.links = scene.look.ground = scene.look.shadows = false;
  taut::Painter painter(scene, standard());
  for (auto round : run) {
    scene.camera.eye->x() += 1e-3;
    painter.submit(*painter.shape({&scene.start}));
    benchmark::DoNotOptimize(painter.fetch());
  }
}

void add(const char* stage, void (*what)(benchmark::State&, Subject)) {
  for (const Subject& subject :
       {Subject{"curtain", 5.0}, {"breaking-cloth", 4.0}, {"hanging-chain", 2.0}, {"ragdoll-pile", 1.4}})
    benchmark::RegisterBenchmark((std::string(stage) + "/" + subject.scene).c_str(), what, subject)
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMillisecond);
}

const bool added = [] {
  add("shape", shape);
  add("draw", draw);
  add("flatten", finish);
  add("compress", compress);
  add("whole", whole_picture);
  benchmark::RegisterBenchmark("draw/empty picture", empty_picture)
      ->MeasureProcessCPUTime()
      ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
