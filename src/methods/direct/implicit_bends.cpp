// The energy E = k (φ − φ₀)²/2 of a bend has second derivatives
//   k ∇φ ∇φᵀ + k (φ − φ₀) ∇²φ.
// Newton's method needs no more of them than it takes to converge, and a matrix that is positive definite;
// the forces are exact. The first part is what turns the links further in their plane. Of the second what
// counts is the turn out of it: where link i goes sideways by δᵢ, as an angle, cos φ becomes
//   cos φ (1 − δ₁²/2 − δ₂²/2) + δ₁ δ₂,  so  φ changes by  cot φ (δ₁² + δ₂²)/2 − δ₁ δ₂/sin φ
//     = cot(φ/2) (δ₁ − δ₂)²/4 − tan(φ/2) (δ₁ + δ₂)²/4.
// The first of these two is positive where φ > φ₀, and in a straight rod as large as ∇φ ∇φᵀ: without it
// nothing would hold the rod in the other one of its two directions, and rounds in space would not converge.
// With s the gradient of δ₁ − δ₂ it is  k (φ − φ₀)/2 cot(φ/2) s sᵀ.

#include "direct/implicit_bends.h"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr double straight = 1e-6;  // rad, below which (φ/2) cot(φ/2) is 1

// (φ − φ₀)/2 cot(φ/2) where that is positive.
double sideways_share(double angle, double rest) {
  if (angle < straight) return rest > straight ? 0.0 : 1.0;
  return std::max(0.0, 0.5 * (angle - rest) / std::tan(0.5 * angle));
}

}  // namespace

// Where a link goes sideways its end moves at right angles to it and to the plane; and so does the gradient
// of φ there turn.
BendStiffness bend_stiffness(const Bend& bend, const Vectors& position) {
  const BendAngle turn = bend_gradients(bend, position);
  const Vec3 middle = position.at(bend.masses[1]);
  const auto across = [&](std::size_t end) -> Vec3 {
    return (position.at(bend.masses[end]) - middle).normalized().cross(turn.gradient[end]);
  };
  BendStiffness stiffness;
  stiffness.in_plane = turn.gradient;
  stiffness.sideways[0] = across(0);
  stiffness.sideways[2] = -across(2);
  stiffness.sideways[1] = -stiffness.sideways[0] - stiffness.sideways[2];
  stiffness.share = sideways_share(turn.angle, bend.rest);
  return stiffness;
}

void ImplicitBends::add_gradient(double h, const Vectors& position, Vectors& sum) const {
  for (const Bend& bend : bends_) {
    const BendAngle turn = bend_gradients(bend, position);
    const double torque = h * h * bend.stiffness * (turn.angle - bend.rest);
    for (std::size_t k = 0; k < 3; ++k) sum.add(bend.masses[k], torque * turn.gradient[k]);
  }
}

void ImplicitBends::add_stiffness(double h, const Vectors& position, BalanceMatrix& matrix) const {
  for (const Bend& bend : bends_) {
    const BendStiffness of = bend_stiffness(bend, position);
    const double strength = h * h * bend.stiffness;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const Eigen::Matrix3d in_plane = of.in_plane[i] * of.in_plane[j].transpose(),
                              sideways = of.sideways[i] * of.sideways[j].transpose();
        matrix.add(bend.masses[i], bend.masses[j], strength * (in_plane + of.share * sideways));
      }
  }
}

}  // namespace taut
