#pragma once

#include <variant>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// A pin at rest + amplitude·sin(angular_frequency·t + phase), from t = 0 on.
struct Sinusoid {
  Vec3 rest = Vec3::Zero();        ///< m
  Vec3 amplitude = Vec3::Zero();   ///< m
  double angular_frequency = 0.0;  ///< rad/s
  double phase = 0.0;              ///< rad
};

/// One knot of a path: where a pin is at a time.
struct Knot {
  double time = 0.0;             ///< s
  Vec3 position = Vec3::Zero();  ///< m
};

/// A pin that follows knots over time and stays put before the first and after the last one. Between knots a
/// quintic polynomial with zero acceleration at every knot: position, velocity and acceleration are
/// continuous everywhere (a kink would be an impulse). The velocities at the knots are harmonic means of the
/// slopes on either side, zero where a coordinate turns or dwells, so no coordinate overshoots its knots or
/// turns between them.
struct Path {
  std::vector<Knot> knots;       ///< times strictly increasing
  std::vector<Vec3> velocities;  ///< m/s at the knots; filled by make_path()
};

using Motion = std::variant<Sinusoid, Path>;

/// The path through the knots (at least one, times strictly increasing).
Path make_path(std::vector<Knot> knots);

/// Where a motion is at a time (m).
Vec3 position_at(const Motion& motion, double time);

/// How fast it moves then (m/s): the exact derivative of position_at().
Vec3 velocity_at(const Motion& motion, double time);

/// The exact derivative of velocity_at() (m/s²).
Vec3 acceleration_at(const Motion& motion, double time);

}  // namespace taut
