#pragma once

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Velocities without what links would stop at once: v − W Jᵀ μ with (J W Jᵀ) μ = J v over the whole rigid
/// links. This is what a report shows of methods that keep half a kick in their velocities
/// (Capabilities::half_kicked). Returned as they are where the system is singular.
Vectors projected_velocities(const Model& model, const State& state);

}  // namespace taut
