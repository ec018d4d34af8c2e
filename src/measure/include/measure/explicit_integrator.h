#pragma once

#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The states at the given rising times by Dormand and Prince's explicit Runge–Kutta pair of order 5(4) on
/// the equations at acceleration level (methods/acceleration.h), with step control: the local error of every
/// position stays below `tolerance` (m) and that of every velocity below ten times that per second. A second
/// opinion of another kind than any method in the registry: nothing is projected, and link lengths drift by
/// the integration error alone. Only the times that were reached, where the equations are singular or the
/// work exceeds `most_evaluations`. (Dormand and Prince, A family of embedded Runge–Kutta formulae, 1980.)
std::vector<State> integrate_explicitly(const Model& model, const State& start,
                                        const std::vector<double>& times, double tolerance,
                                        long most_evaluations = 2'000'000);

}  // namespace taut
