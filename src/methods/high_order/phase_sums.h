#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "axes.h"
#include "base/vectors.h"
#include "base/workers.h"

namespace taut {

/// So many masses, or links, at least are shared between threads: a half of them takes some ten microseconds,
/// beside which to call a thread is nothing.
inline constexpr std::size_t fewest_to_share_in_halves = 4096;

/// The larger of two; NaN where one of them is.
inline double larger_or_none(double a, double b) {
  return std::isnan(a) || a > b ? a : b;
}

/// Positions and velocities of all masses.
struct Phase {
  Vectors position, velocity;
};

/// Sums over vectors of all masses, such as the accelerations of stages, for positions and velocities at
/// once.
struct VectorSums {
  struct Term {
    AxesToRead axes;
    double in_position, in_velocity;  ///< weights
  };
  static constexpr std::size_t most = 20;  ///< the interpolant's
  std::array<Term, most> terms{};
  std::size_t count = 0;

  void add(const Vectors& vectors, double in_position, double in_velocity) {
    terms[count++] = {to_read(vectors), in_position, in_velocity};
  }
};

/// Where all masses are:
///   x = start + drift · velocity at the start + Σ …,   v = velocity at the start + Σ …
struct PhaseSums {
  std::size_t masses = 0;
  AxesToRead position{}, velocity{};  ///< m, m/s, at the start
  double drift = 0.0;                 ///< s
  VectorSums sums;

  /// Begins anew, with nothing but the start.
  void start(const Vectors& from, const Vectors& at_speed, double for_time) {
    masses = from.size();
    position = to_read(from);
    velocity = to_read(at_speed);
    drift = for_time;
    sums.count = 0;
  }
};

/// Works the sums out. `phase` must not be among what is summed.
void write_phase(const PhaseSums& at, Phase& phase);

/// The largest |coordinate| of sums of each kind; NaN where one is not finite.
struct LargestSums {
  double position = 0.0, velocity = 0.0;
};

/// Works the sums out, and looks at two others over the same vectors: memory is read once for all. Two of
/// the workers, if any, share many masses.
std::array<LargestSums, 2> write_phase(const PhaseSums& at, const std::array<VectorSums, 2>& others,
                                       Workers* workers, Phase& phase);

}  // namespace taut
