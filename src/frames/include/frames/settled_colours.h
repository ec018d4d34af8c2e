#pragma once

#include <span>
#include <vector>

#include "base/stop.h"
#include "methods/method.h"
#include "output/motion_file.h"
#include "scene/scene.h"

namespace taut {

/// Settles the range of colours of pictures of given states, where the scene leaves it open.
void settle_colours(Scene& scene, const std::vector<State>& states);

/// The same for pictures of a motion that was simulated before.
void settle_colours(Scene& scene, const MotionReader& motion);

/// The same for a film of scenes that differ in method alone: all get one range, from the whole of their
/// runs, whichever frames are wanted. So each is run twice, which a look.colour_range in the scene spares.
/// Throws Interrupted.
void settle_colours(std::span<Scene> scenes, const Execution& execution, const StopTest& stop = {});

}  // namespace taut
