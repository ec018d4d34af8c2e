#include "frames/settled_colours.h"

#include <optional>

#include "frames/colouring.h"
#include "motion/run.h"
#include "render/colour_range.h"

namespace taut {
namespace {

// Moments of a run that are looked at.
constexpr int moments_for_colours = 60;

bool has_open_range(const Look& look) {
  return look.colour_by != ColourBy::plain && look.colour_by != ColourBy::limit && !(look.colour_range > 0.0);
}

void add_run(const Scene& scene, const Execution& execution, const StopTest& stop, ColourRange& range) {
  Run run(scene.model, scene.start, scene.settings, {}, execution);
  for (int moment = 0; moment <= moments_for_colours; ++moment) {
    const std::optional<State> state = run.at(scene.duration * moment / moments_for_colours, stop);
    // Why a run ends early is said when its pictures are made.
    if (run.ended()) return;
    if (!state) throw Interrupted();
    range.add(scene.model, *state, scene.look);
  }
}

}  // namespace

void settle_colours(Scene& scene, const std::vector<State>& states) {
  if (!has_open_range(scene.look)) return;
  ColourRange range(scene.look.colour_by);
  for (const State& state : states) range.add(scene.model, state, scene.look);
  scene.look.colour_range = range.top();
}

void settle_colours(Scene& scene, const MotionReader& motion) {
  if (!has_open_range(scene.look)) return;
  ColourRange range(scene.look.colour_by);
  for (int moment = 0; moment <= moments_for_colours; ++moment)
    range.add(scene.model, motion.between(scene.duration * moment / moments_for_colours, scene.model),
              scene.look);
  scene.look.colour_range = range.top();
}

void settle_colours(std::span<Scene> scenes, const Execution& execution, const StopTest& stop) {
  if (!has_open_range(scenes.front().look)) return;
  ColourRange range(scenes.front().look.colour_by);
  for (const Scene& scene : scenes)
    if (colour_problem(scene).empty()) add_run(scene, execution, stop, range);
  for (Scene& scene : scenes) scene.look.colour_range = range.top();
}

}  // namespace taut
