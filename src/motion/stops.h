#pragma once

#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Which hard stops on angles a state touches (within 1e-9 rad), the upper and then the lower one of each
/// limit.
std::vector<bool> touched_stops(const Model& model, const State& state);

/// Whether one is touched that was not.
bool meets_more(const std::vector<bool>& touched, const std::vector<bool>& before);

/// The time (s) in which the first hard stop that was not touched would be, were angles to go on at their
/// rates; infinity where none would.
double time_to_stop(const Model& model, const State& state, const std::vector<bool>& touched);

}  // namespace taut
