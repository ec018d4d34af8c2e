#pragma once

#include <vector>

#include "base/vectors.h"

namespace taut {

/// The angle below level (rad, 0 at release, up to π) of a rigid pendulum of the given length (m) released
/// level at rest, at a time (s): the angle from the vertical φ has sin(φ/2) = k·sn(K − t√(g/L) | k), k² =
/// 1/2.
double pendulum_angle_below_level(double length, double gravity, double time);

/// Its period (s): 4 K(k) √(L/g), k² = 1/2.
double pendulum_period(double length, double gravity);

/// A chain at rest between two pins.
struct HangingChain {
  std::vector<Vec3> positions;   ///< m, link_count + 1 of them, pins included
  std::vector<double> tensions;  ///< N, one a link
  double sag = 0.0;              ///< m, of the lowest mass below the lower pin
};

/// The exact rest shape of a chain of equal links and equal masses at its inner joints between two pins in
/// the x-y plane: the horizontal force H is constant along it and the vertical force steps by the weight at
/// each mass, so the link between (H, V_i) lies along that force and has length l + compliance·|force|. H and
/// V_0 are found by Newton's method on the position of the last pin, to rounding.
HangingChain hanging_chain_at_rest(const Vec3& from, const Vec3& to, int link_count, double link_length,
                                   double compliance, double weight_per_mass);

}  // namespace taut
