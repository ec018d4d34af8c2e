#pragma once

#include <vector>

#include "model/bends.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The bends of a model as forces: f = −k (φ − φ₀) ∇φ.
class BendForces {
 public:
  BendForces() = default;
  /// Of those that are whole in the state.
  BendForces(const Model& model, const State& state);

  bool empty() const { return bends_.empty(); }

  /// Adds to the free masses' velocities what the bends do in h seconds.
  void kick(double h, const Vectors& position, Vectors& velocity) const;

  /// Adds to each mass's sum what bounds the stiffness it meets over its mass: k |∇ₐφ| Σ |∇φ| /m (1/s²).
  void add_rows(const Vectors& position, std::vector<double>& sum) const;

  /// product += M⁻¹ K mode, with K = Σ k ∇φ ∇φᵀ.
  void add_product(const Vectors& position, const Vectors& mode, Vectors& product) const;

 private:
  std::vector<Bend> bends_;
  std::vector<double> inverse_mass_;  // 1/kg, one a mass
};

}  // namespace taut
