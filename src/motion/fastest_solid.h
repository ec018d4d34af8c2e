#pragma once

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The speed (m/s) that no place of a solid's surface which masses can be at exceeds at any time: what a run
/// may give to what touches it. 0 where no solid moves.
double fastest_solid(const Model& model, const State& start);

}  // namespace taut
