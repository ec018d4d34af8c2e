#include "scene_target.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/failure.h"
#include "frames/painter.h"
#include "frames/settled_view.h"
#include "measure/pace.h"
#include "methods/registry.h"
#include "motion/run.h"
#include "render/camera.h"
#include "render/geometry.h"
#include "scene/scene.h"

namespace taut::testing {
namespace {

constexpr Size picture{64, 64};
constexpr double most_parts = 500.0;  // masses, and links
constexpr int steps = 10;
constexpr double most_passes = 4.0;

struct TooLarge {};

[[noreturn]] void give_up(std::string_view why) {
  std::fprintf(stderr, "%.*s\n", static_cast<int>(why.size()), why.data());
  std::abort();
}

void leave_large_ones(const Counts& counts) {
  if (std::max(counts.masses, counts.links) > most_parts) throw TooLarge();
}

// What takes long is no mistake, but it would take the time of everything else.
StopTest for_a_second() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  return [end] { return std::chrono::steady_clock::now() > end; };
}

// The same scene, resolved, must be a scene again, with the same text.
void expect_resolved_text_to_last(const Scene& scene) {
  const std::string resolved = resolved_toml(scene);
  try {
    if (resolved_toml(parse_scene(resolved, "fuzz.toml")) != resolved) give_up("the resolved text changes");
  } catch (const BadRequest& failure) {
    give_up(std::string("the resolved text is refused: ") + failure.what());
  }
}

State stepped(const Scene& scene) {
  Settings settings = scene.settings;
  if (settings.values.contains("passes"))
    settings.values["passes"] = std::min(settings.number("passes"), most_passes);
  State state = scene.start;
  try {
    Run run(scene.model, scene.start, settings);
    const double end = std::min(scene.duration, steps / pace_of(scene.model, settings));
    if (const std::optional<State> reached = run.at(end, for_a_second())) state = *reached;
    if (run.ended() && run.failure().empty()) give_up("a run has ended for no reason");
  } catch (const BadRequest& refusal) {
    if (std::string_view(refusal.what()).empty()) give_up("a refusal without a reason");
  }
  if (!all_finite(state)) give_up("a state that a run gave is not finite");
  return state;
}

void show(const Scene& given, const State& state, Depth depth) {
  std::array<Scene, 1> scenes{given};
  Scene& scene = scenes.front();
  scene.duration = std::min(scene.duration, 0.02);
  scene.look.exact = false;
  settle_views(scenes, picture, for_a_second());
  const Trails trails;
  if (depth == Depth::picture) {
    PictureSettings settings;
    settings.render = render_settings_for(Quality::draft, picture);
    settings.gl = *gl_choice_named("osmesa");
    Painter(scene, settings).draw(state);
    return;
  }
  const auto pose = [&](const State& of) { return camera_pose(scene.camera, scene.model, scene.start, of); };
  GeometryMaker(scene.model, scene.start, scene.look, Sight{pose(scene.start), picture})
      .make(state, pose(state));
}

}  // namespace

void try_scene(const std::string& text, Depth depth) {
  try {
    const Scene scene = parse_scene(text, "fuzz.toml", {}, leave_large_ones);
    expect_resolved_text_to_last(scene);
    show(scene, stepped(scene), depth);
  } catch (const BadRequest& failure) {
    if (std::string_view(failure.what()).empty()) give_up("an error without a message");
  } catch (const RunFailure& failure) {
    if (std::string_view(failure.what()).empty()) give_up("a failure without a message");
  } catch (const Interrupted&) {  // a look ahead took its second
  } catch (const TooLarge&) {
  }
}

}  // namespace taut::testing
