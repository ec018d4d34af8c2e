#pragma once

#include <array>
#include <optional>

#include "base/vectors.h"

namespace taut {

/// The share of a picture that its subject is kept out of, along each edge.
inline constexpr double usual_margin = 0.07;

/// Finds the nearest eye, in a given direction, from which balls are seen whole. A ball is within an edge of
/// the picture where it is on the inner side of the plane through the eye and that edge; of all balls only
/// how far they reach along the normals of the four planes is kept, so there may be any number.
class CameraFit {
 public:
  /// `axes`: the picture's right and top, and what points back at the eye, as columns. `field_of_view`:
  /// degrees, from the lower to the upper edge. `aspect`: width ÷ height. `margin`: share of the picture, at
  /// each edge, to keep free. With a `centre` the picture's middle stays there.
  CameraFit(const Eigen::Matrix3d& axes, double field_of_view, double aspect, double margin,
            const std::optional<Vec3>& centre = {});

  /// A ball (m).
  void add(const Vec3& place, double radius);
  bool empty() const { return nearest_ < -1e300; }

  /// An eye and a target.
  struct Place {
    Vec3 eye, target;
  };
  /// From where all is seen, at least `least_distance` (m) from the nearest of it. There must be something.
  Place place(double least_distance) const;

 private:
  Eigen::Matrix3d axes_;
  std::array<double, 2> slope_;  // of the line of sight to the margin, to the right and up
  std::array<double, 2> reach_;  // √(1 + slope²)
  std::optional<Vec3> centre_;   // along the axes
  // Farthest of x + slope z and −x + slope z, and the same of y (m).
  std::array<double, 2> plus_{-1e301, -1e301}, minus_{-1e301, -1e301};
  double nearest_ = -1e301, farthest_ = 1e301;  // along what points back at the eye (m)
};

}  // namespace taut
