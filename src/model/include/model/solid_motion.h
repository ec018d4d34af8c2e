#pragma once

#include <variant>

#include "model/way.h"

namespace taut {

/// A turn whose rate is reached smoothly within `rise` and then kept, from t = 0 on.
struct SteadyTurn {
  double rate = 0.0;  ///< rad/s, right-handed about the axis
  double rise = 0.0;  ///< s
};

/// How a solid moves: it turns about an axis, and is carried along with the point that it turns about. In the
/// model it stands as it would without any of that.
struct SolidMotion {
  Vec3 centre = Vec3::Zero();  ///< m, what it turns about
  Vec3 axis = Vec3::UnitZ();   ///< unit length
  /// About the axis: not at all, at a rate, or through angles (rad), which are the x of the path.
  std::variant<std::monostate, SteadyTurn, Path> turn;
  Vec3 from = Vec3::Zero();  ///< m, where the way is taken to begin: it is carried by the difference
  std::variant<std::monostate, Sinusoid, Path> way;
};

/// Where a solid is: what stands at p in the model stands at to + turn (p − from).
struct Placement {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< m

  Vec3 place(const Vec3& p) const { return to + turn * (p - from); }
  Vec3 back(const Vec3& place) const { return from + turn.transpose() * (place - to); }
};

/// How a solid moves on: the velocity of what is at p is speed + spin × (p − about), and so on for its
/// derivative.
struct Twist {
  Vec3 about = Vec3::Zero();                                     ///< m
  Vec3 speed = Vec3::Zero(), spin = Vec3::Zero();                ///< m/s, rad/s
  Vec3 speed_change = Vec3::Zero(), spin_change = Vec3::Zero();  ///< m/s², rad/s²

  Vec3 velocity(const Vec3& p) const { return speed + spin.cross(p - about); }
  Vec3 acceleration(const Vec3& p) const {
    return speed_change + spin_change.cross(p - about) + spin.cross(spin.cross(p - about));
  }
};

/// Where a solid is at a time; position, velocity and acceleration of all of it are continuous (but for a
/// turn at once at a rate, with no time to rise).
Placement placement_at(const SolidMotion& motion, double time);

/// How it moves then: the exact derivatives of placement_at().
Twist twist_at(const SolidMotion& motion, double time);

}  // namespace taut
