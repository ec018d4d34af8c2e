#pragma once

#include <array>
#include <utility>
#include <vector>

#include "direct/balance_matrix.h"
#include "model/bends.h"
#include "model/model.h"

namespace taut {

/// What is positive of the second derivatives of a bend's energy: k (∇φ ∇φᵀ + share s sᵀ), in the plane of
/// its links and out of it. See implicit_bends.cpp.
struct BendStiffness {
  std::array<Vec3, 3> in_plane, sideways;  ///< ∇φ and s (1/m), at each of its masses
  double share = 0.0;
};
BendStiffness bend_stiffness(const Bend& bend, const Vectors& position);

/// The bends of a model at the end of an implicit step of h seconds, times h².
class ImplicitBends {
 public:
  explicit ImplicitBends(std::vector<Bend> whole) : bends_(std::move(whole)) {}

  bool empty() const { return bends_.empty(); }

  /// Adds the gradient of the energy at each mass: h² k (φ − φ₀) ∇φ (kg m).
  void add_gradient(double h, const Vectors& position, Vectors& sum) const;

  /// Adds the stiffness h² K at some positions (kg).
  void add_stiffness(double h, const Vectors& position, BalanceMatrix& matrix) const;

 private:
  std::vector<Bend> bends_;
};

}  // namespace taut
