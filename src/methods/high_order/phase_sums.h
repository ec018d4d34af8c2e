#pragma once

#include <array>
#include <cstddef>

#include "base/vectors.h"

namespace taut {

/// Positions and velocities of all masses.
struct Phase {
  Vectors position, velocity;
};

/// The x, y and z of all masses.
using Axes = std::array<const double*, 3>;
inline Axes axes_of(const Vectors& vectors) {
  return {vectors.x.data(), vectors.y.data(), vectors.z.data()};
}

/// Sums over vectors of all masses, such as the accelerations of stages, for positions and velocities at
/// once.
struct VectorSums {
  struct Term {
    Axes axes;
    double in_position, in_velocity;  ///< weights
  };
  static constexpr std::size_t most = 20;
  std::array<Term, most> terms{};
  std::size_t count = 0;

  void add(const Vectors& vectors, double in_position, double in_velocity) {
    if (in_position == 0.0 && in_velocity == 0.0) return;
    terms[count++] = {axes_of(vectors), in_position, in_velocity};
  }
};

/// Where all masses are:
///   x = start + drift · velocity at the start + Σ …,   v = velocity at the start + Σ …
struct PhaseSums {
  std::size_t masses = 0;
  Axes position{}, velocity{};  ///< m, m/s, at the start
  double drift = 0.0;           ///< s
  VectorSums sums;

  /// Begins anew, with nothing but the start.
  void start(const Vectors& from, const Vectors& at_speed, double for_time) {
    masses = from.size();
    position = axes_of(from);
    velocity = axes_of(at_speed);
    drift = for_time;
    sums.count = 0;
  }
};

/// Works the sums out. `phase` must not be among what is summed.
void write_phase(const PhaseSums& at, Phase& phase);

/// The largest |coordinate| of sums; NaN where one is not a number.
struct LargestSums {
  double position = 0.0, velocity = 0.0;
};
LargestSums largest_sums(const VectorSums& sums, std::size_t masses);

}  // namespace taut
