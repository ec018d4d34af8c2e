#pragma once

#include <vector>

#include "forces/springs.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Accelerations (m/s²) of all masses but for what rigid links do: gravity, loads, drag, wind, springs and
/// the motions of driven pins. `whole` tells what is broken. The springs' pulls (N) go into `spring_tension`.
void free_accelerations(const Model& model, const State& whole, const Springs& springs, double time,
                        const Vectors& position, const Vectors& velocity, Vectors& acceleration,
                        std::vector<double>& spring_tension);

}  // namespace taut
