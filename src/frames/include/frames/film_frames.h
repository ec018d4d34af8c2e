#pragma once

#include "base/frame_rate.h"
#include "scene/scene.h"

namespace taut {

/// How many frames a scene's film has. Throws BadRequest where they are none or too many.
int film_frame_count(const Scene& scene, const FrameRate& rate);

/// The time of the scene's run (s) that a frame of its film shows.
double shown_time(const Scene& scene, int frame, const FrameRate& rate);

}  // namespace taut
