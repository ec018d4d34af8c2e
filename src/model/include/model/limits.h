#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/vectors.h"

namespace taut {

/// What a limit measures.
///
/// angle: masses a, b, c; the angle at b between a and c, 0 to π.
/// hinge: masses a, b, c, p, q; how far c is turned on from the straight continuation of a beyond b, about
/// the
///        axis from p to q, right-handed, −π to π. p or q may be b.
/// cone:  masses o, p, q, b, c, d; the angle, 0 to π, between an axis fixed in the frame of o, p, q and the
///        limb from b to the middle of c and d. d may be c, b may be of the frame.
/// reach: masses a, b; how far apart they are, 0 to infinity, in lengths of the link between them, which acts
///        only at the ends of the range: read "lengths" for rad below, and a force times that length for a
///        torque.
enum class LimitKind : std::uint8_t { angle, hinge, cone, reach };

inline constexpr Index no_link = std::numeric_limits<Index>::max();

inline constexpr std::size_t most_limit_masses = 6;

/// A range an angle between masses is kept in: a stop at either end, which only pushes back.
struct Limit {
  LimitKind kind = LimitKind::angle;
  std::uint8_t count = 3;                         ///< of its masses
  std::array<Index, most_limit_masses> masses{};  ///< in the order given at LimitKind
  Vec3 axis = Vec3::UnitX();                      ///< of a cone, unit length, in its frame
  double min = 0.0, max = std::numbers::pi;       ///< rad
  double compliance = 0.0;                        ///< rad/(N m); 0: a hard stop
  double length = 1.0;                            ///< m, of a reach: what it is measured in
  Index link = no_link;                           ///< of a reach: its link, without which it holds nothing
};

/// An angle and its gradient with respect to each of the limit's masses (rad/m). Where a limit names a mass
/// twice, the first of them has the whole gradient and the other none.
struct LimitAngle {
  double angle = 0.0;  ///< rad
  std::array<Vec3, most_limit_masses> gradient;
};

/// How far an angle is beyond the nearer end of its range.
struct Overshoot {
  double size = 0.0;  ///< rad; negative inside the range
  double sign = 1.0;  ///< +1 at the upper end, −1 at the lower: the overshoot's gradient over the angle's
};

/// The angle at the second of three masses (rad), and its gradients at the three.
double corner_angle(const std::array<Index, 3>& masses, const Vectors& position);
LimitAngle corner_gradients(const std::array<Index, 3>& masses, const Vectors& position);

/// The angle alone (rad).
double limit_angle(const Limit& limit, const Vectors& position);

/// The angle and its gradients. They sum to no force and no torque: the angle does not change when all masses
/// are moved or turned together. Where the direction of a gradient is lost (an angle of 0 or π, a limb on the
/// hinge's axis) it is any one of those that are as good.
LimitAngle limit_gradients(const Limit& limit, const Vectors& position);

/// Beyond which end of the limit an angle is; for a hinge, round the circle the shorter way.
Overshoot overshoot(const Limit& limit, double angle);

/// Whether there is anything to be met at one end of the limit, +1 the upper or −1 the lower: angles and
/// cones end at 0 and π by themselves.
bool has_stop(const Limit& limit, double sign);

/// How far an angle is beyond one end of the limit, +1 the upper or −1 the lower, whichever is nearer;
/// negative inside the range, and for a hinge beyond its other end.
double excess_at(const Limit& limit, double angle, double sign);

/// Right-handed unit axes of the frame of three points as columns: x from o to p, z across the plane of the
/// three. Not finite where they lie on a line.
Eigen::Matrix3d frame_axes(const Vec3& o, const Vec3& p, const Vec3& q);

}  // namespace taut
