#pragma once

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What single precision alone may make of a run's error of place, as a share of scene_size(); 0 in double
/// precision. Positions as large as X hold ε X/2, ε = 2⁻²³; what gravity adds to them in a step, g h², is off
/// by as much, always to the same side, so that masses fall by a share ε X/(2 g h²) too far or too short.
double rounding_error(const Model& model, const State& start, const Settings& settings);

}  // namespace taut
