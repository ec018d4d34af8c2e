#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/vectors.h"
#include "model/way.h"

namespace taut {

// How pins and solids are moved, as a person writes it; see description.h.

struct SinusoidSpec {
  Vec3 amplitude = Vec3::Zero();   ///< m
  double angular_frequency = 0.0;  ///< rad/s
  double phase = 0.0;              ///< rad

  bool operator==(const SinusoidSpec&) const = default;
};

/// How a solid is moved: one of the two, or neither.
struct WaySpec {
  std::optional<SinusoidSpec> sinusoid;
  std::vector<Knot> path;

  bool empty() const { return !sinusoid && path.empty(); }
};

/// How a pin is driven: one of them, or none.
struct MotionSpec {
  std::optional<SinusoidSpec> sinusoid{};
  std::vector<Knot> path{};
  std::string with{};  ///< the name of a solid that carries it

  bool given() const { return sinusoid || !path.empty() || !with.empty(); }
};

/// How a solid turns about an axis: through angles at times, or at a rate.
struct RotationSpec {
  Vec3 axis = Vec3::Zero();                  ///< of any length but 0
  std::optional<Vec3> through;               ///< m, a point of the axis; absent: the solid's centre
  std::vector<std::array<double, 2>> angle;  ///< (s, degrees)
  std::optional<double> rate;                ///< degrees/s
  double rise = 0.0;                         ///< s, in which the rate is reached
};

/// How a solid moves, where it does.
struct SolidMotionSpec {
  std::string name;  ///< for pins that it carries; may be empty
  WaySpec motion;
  std::optional<RotationSpec> rotation;
};

}  // namespace taut
