#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/limits.h"

namespace taut {

/// How one part of a body turns against another.
///
/// hinge: masses as those of LimitKind::hinge; about its axis.
/// swing: masses as those of LimitKind::cone; the limb against the frame, about both directions across the
///        limb.
/// twist: the same masses; the limb against the frame, about its own length. c and d are across the limb.
enum class JointKind : std::uint8_t { hinge, swing, twist };

/// A joint that resists being turned. With ω the rate at which one part turns against the other, it takes
///   damping·ω + friction·ω/|ω|   (N m)
/// from the one and gives it to the other; where it is at rest, friction is what keeps it so, up to its size.
struct Joint {
  JointKind kind = JointKind::hinge;
  std::array<Index, most_limit_masses> masses{};
  double damping = 0.0;   ///< N m s/rad
  double friction = 0.0;  ///< N m, Coulomb's
};

/// The angles whose rates are a joint's ω, as limits to take gradients of, and a direction for each: across
/// the limb and fixed in the frame (swing); any that stays (others).
struct JointAngles {
  std::size_t count = 1;
  std::array<Limit, 2> angles;
  std::array<Vec3, 2> directions{Vec3::UnitX(), Vec3::UnitY()};
};

/// A joint's angles where the masses are now.
JointAngles joint_angles(const Joint& joint, const Vectors& position);

}  // namespace taut
