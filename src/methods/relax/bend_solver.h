#pragma once

#include <cstdint>
#include <vector>

#include "model/bends.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Relaxation of bends, for methods that move positions and derive velocities from them: each as XPBD's
/// compliant constraint (2016, eq. 18) with C = φ − φ₀ and the compliance 1/k,
///   Δλ = (−C − α̃ λ)/(Σ wᵢ|∇ᵢφ|² + α̃),  xᵢ ← xᵢ + wᵢ Δλ ∇ᵢφ,   α̃ = 1/(k h²), wᵢ = answer/mᵢ.
class BendSolver {
 public:
  explicit BendSolver(const Model& model) : model_(model), inverse_mass_(model.masses.inverse_mass) {}

  /// To be called before the first step and whenever links have broken.
  void links_changed(const State& state);

  /// To be called at the start of a step.
  void begin_step();

  /// One pass over all bends: every third one at a time, so that those which share a link don't follow each
  /// other.
  void solve(double h, double answer, Vectors& position);

  std::int64_t size() const { return static_cast<std::int64_t>(bends_.size()); }

 private:
  const Model& model_;
  const std::vector<double>& inverse_mass_;
  std::vector<Bend> bends_;
  std::vector<double> multipliers_;
};

}  // namespace taut
