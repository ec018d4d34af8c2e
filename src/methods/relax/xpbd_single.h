#pragma once

#include <memory>

#include "methods/method.h"
#include "parameters.h"

namespace taut {

/// xpbd with positions, velocities and multipliers in single precision, as engines for games and graphics
/// processors have it: the same scheme link by link, rounded to 24 bits.
std::unique_ptr<Stepper> make_single_xpbd(const Model& model, PassCounts passes);

}  // namespace taut
