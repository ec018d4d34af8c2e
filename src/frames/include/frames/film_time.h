#pragma once

#include "view/view.h"

namespace taut {

/// How long the film of a scene of a duration (s) is, with the look's speeds (s).
double film_duration(const Look& look, double duration);

/// The time of the scene that a film shows at a time of its own (s both).
double scene_time(const Look& look, double film_time);

/// Makes the film so many times as long, whatever its speeds: 4 is slow motion, 0.5 twice as fast. Throws
/// BadRequest where a speed would be below 0.001 or above 1000.
void slow_down(Look& look, double times);

/// How fast the film goes at a time of the scene: so many of the scene's seconds in one of the film.
double film_speed(const Look& look, double time);

}  // namespace taut
