#pragma once

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The largest angular frequency ω_max (rad/s) at which the whole links with stiffness let the free masses
/// vibrate about a state: the root of the largest eigenvalue of M⁻¹K, K = Σ k n nᵀ, by power iteration; 0
/// where no link has stiffness. Explicit steps of springs need ω_max·h < 2.
double highest_spring_frequency(const Model& model, const State& state);

}  // namespace taut
