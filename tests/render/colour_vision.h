#pragma once

#include <array>

namespace taut::testing {

/// Linear light as seen without the cones for green (Viénot, Brettel and Mollon 1999): red and green become
/// one.
inline std::array<double, 3> without_green_cones(const std::array<double, 3>& light) {
  const double yellow = 0.29275 * light[0] + 0.70725 * light[1];
  return {yellow, yellow, -0.02234 * light[0] + 0.02234 * light[1] + light[2]};
}

}  // namespace taut::testing
