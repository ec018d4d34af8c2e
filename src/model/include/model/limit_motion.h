#pragma once

#include "model/limits.h"

namespace taut {

/// How a limit's angle moves with its masses.
struct LimitMotion {
  double rate = 0.0;    ///< rad/s
  double change = 0.0;  ///< rad/s², of the rate while no mass is accelerated: vᵀ (∂²θ/∂x²) v
};

/// Not finite where the angle has no gradient (an angle of 0 or π, a limb on a hinge's axis).
LimitMotion limit_motion(const Limit& limit, const Vectors& position, const Vectors& velocity);

}  // namespace taut
