#pragma once

#include <vector>

#include "base/vectors.h"

namespace taut {

/// A place at rest + amplitude·sin(angular_frequency·t + phase), from t = 0 on.
struct Sinusoid {
  Vec3 rest = Vec3::Zero();        ///< m
  Vec3 amplitude = Vec3::Zero();   ///< m
  double angular_frequency = 0.0;  ///< rad/s
  double phase = 0.0;              ///< rad
};

/// One knot of a path: where something is at a time.
struct Knot {
  double time = 0.0;             ///< s
  Vec3 position = Vec3::Zero();  ///< m
};

/// A way through knots over time, which stays put before the first and after the last one. Between knots a
/// quintic polynomial with zero acceleration at every knot: position, velocity and acceleration are
/// continuous everywhere (a kink would be an impulse). The velocities at the knots are harmonic means of the
/// slopes on either side, zero where a coordinate turns or dwells, so no coordinate overshoots its knots or
/// turns between them.
struct Path {
  std::vector<Knot> knots;       ///< times strictly increasing
  std::vector<Vec3> velocities;  ///< m/s at the knots; filled by make_path()
};

/// The path through the knots (at least one, times strictly increasing).
Path make_path(std::vector<Knot> knots);

/// Where such a way leads to at a time (m), how fast (m/s), and how that changes (m/s²): exact derivatives.
Vec3 position_at(const Sinusoid& way, double time);
Vec3 position_at(const Path& way, double time);
Vec3 velocity_at(const Sinusoid& way, double time);
Vec3 velocity_at(const Path& way, double time);
Vec3 acceleration_at(const Sinusoid& way, double time);
Vec3 acceleration_at(const Path& way, double time);

}  // namespace taut
