#pragma once

#include <span>

#include "base/image.h"
#include "base/stop.h"
#include "scene/scene.h"

namespace taut {

/// Settles what scenes that differ in method alone leave open of their camera and their drawn ground, for
/// pictures of a size; all get the same.
///
/// An eye that isn't given goes where all that there is to show is in view: the corners of camera.show or,
/// without one, every place that a mass comes to in a coarse look ahead. That is a run of the whole scene by
/// xpbd with fewer steps, a few tenths of a second for the largest scenes, and the same whichever frames are
/// wanted. An eye that is given stays, and pictures narrower than 16:9 see as far to its sides as those.
/// Where no plane and no look.ground_height says otherwise, a ground at height 0 that something comes to lie
/// below goes below that. Throws Interrupted.
void settle_views(std::span<Scene> scenes, Size size, const StopTest& stop = {});

}  // namespace taut
