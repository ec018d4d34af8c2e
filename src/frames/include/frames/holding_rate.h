#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace taut {

/// The fewest steps per second (to 10 %) at which the scene's method holds, guard off, from the start of the
/// scene to a time (s) and for at least 100 steps, as a stability map would have it: more than the scene's
/// own are tried, each time twice as many, and the last doubling is bisected. Nothing where none is found
/// before about ten million links have been solved, a matter of seconds.
std::optional<double> holding_rate(const Scene& scene, double until);

/// That as the end of an error message: "; it would hold at 480 steps_per_second".
std::string holding_rate_hint(const Scene& scene, double until);

}  // namespace taut
