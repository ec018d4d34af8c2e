#pragma once

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The largest angular frequency ω_max (rad/s) at which the whole links with stiffness let the free masses
/// vibrate about a state: the root of the largest eigenvalue of M⁻¹K, K = Σ k n nᵀ, by power iteration; 0
/// where no link has stiffness. Explicit steps of springs need ω_max·h < 2.
double highest_spring_frequency(const Model& model, const State& state);

/// A bound of it from above (rad/s), found by one look at every link: no eigenvalue of M⁻¹K is larger than
/// the largest sum of 2 Σ k/m over the links at a mass (Gershgorin's circles, of whole masses). For a long
/// chain it is exact; for a net with diagonals up to 1.6 times too large.
double spring_frequency_bound(const Model& model, const State& state);

}  // namespace taut
