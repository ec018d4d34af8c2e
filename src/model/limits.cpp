#include "model/limits.h"

#include <cmath>

namespace taut {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// A vector over its squared length: how fast a lever turns when its end is moved across it.
Vec3 per_square(const Vec3& across, const Vec3& lever) {
  const double square = lever.squaredNorm();
  return square > 0.0 ? Vec3(across / square) : Vec3::Zero();
}

// Unit vector about which the shorter turn from a to c goes; any across a where they lie on one line.
Vec3 turning_axis(const Vec3& a, const Vec3& c) {
  const Vec3 across = a.cross(c);
  const double size = across.norm();
  return size > 1e-12 * a.norm() * c.norm() ? Vec3(across / size) : a.unitOrthogonal();
}

double angle_between(const Vec3& a, const Vec3& c) {
  return std::atan2(a.cross(c).norm(), a.dot(c));
}

// A hinge's levers from b, their parts across the axis, and how far along the axis they reach, as a share of
// its length.
struct HingeLevers {
  Vec3 axis, a, c;
  double along_a, along_c;
};

HingeLevers hinge_levers(const Limit& limit, const Vectors& position) {
  const Vec3 b = position.at(limit.masses[1]);
  const Vec3 a = position.at(limit.masses[0]) - b, c = position.at(limit.masses[2]) - b;
  const Vec3 span = position.at(limit.masses[4]) - position.at(limit.masses[3]);
  const double length = span.norm();
  const Vec3 axis = span / length;
  const double on_a = a.dot(axis), on_c = c.dot(axis);
  return {axis, a - on_a * axis, c - on_c * axis, on_a / length, on_c / length};
}

double bend(const HingeLevers& levers) {
  return std::atan2(-levers.axis.dot(levers.a.cross(levers.c)), -levers.a.dot(levers.c));
}

Vec3 cone_limb(const Limit& limit, const Vectors& position) {
  return 0.5 * (position.at(limit.masses[4]) + position.at(limit.masses[5])) - position.at(limit.masses[3]);
}

Eigen::Matrix3d cone_frame(const Limit& limit, const Vectors& position) {
  return frame_axes(position.at(limit.masses[0]), position.at(limit.masses[1]), position.at(limit.masses[2]));
}

// Only what is across the axis e = (q − p)/|q − p| counts: a⊥ = a − e (e·a), and the bend is the turn from
// −a⊥ to c⊥ about e. Tilting e by δe changes a⊥ as moving a by −δe (e·a) would, and so
//   ∇q = −((e·a) ∇a + (e·c) ∇c)/|q − p| = −∇p.
LimitAngle hinge_gradients(const Limit& limit, const Vectors& position) {
  const HingeLevers levers = hinge_levers(limit, position);
  LimitAngle result;
  result.angle = bend(levers);
  result.gradient[0] = -per_square(levers.axis.cross(levers.a), levers.a);
  result.gradient[2] = per_square(levers.axis.cross(levers.c), levers.c);
  result.gradient[1] = -result.gradient[0] - result.gradient[2];
  result.gradient[4] = -levers.along_a * result.gradient[0] - levers.along_c * result.gradient[2];
  result.gradient[3] = -result.gradient[4];
  return result;
}

// The angle changes by n·ω when the limb turns by ω, and by −n·ω when the frame does, n being the axis of the
// turn from the cone's axis to the limb. The frame's turn follows from its edges e₁ = p − o and e₂ = q − o =
// αX + βY:
//   ω·Z = Y·δe₁/|e₁|,  ω·Y = −Z·δe₁/|e₁|,  ω·X = (Z·δe₂ − α Z·δe₁/|e₁|)/β.
LimitAngle cone_gradients(const Limit& limit, const Vectors& position) {
  const Vec3 o = position.at(limit.masses[0]);
  const Vec3 first = position.at(limit.masses[1]) - o, second = position.at(limit.masses[2]) - o;
  const Eigen::Matrix3d frame = cone_frame(limit, position);
  const Vec3 axis = frame * limit.axis, limb = cone_limb(limit, position);
  const Vec3 n = turning_axis(axis, limb);
  const Vec3 in_frame = frame.transpose() * n;
  const double alpha = second.dot(frame.col(0)), beta = second.dot(frame.col(1));

  LimitAngle result;
  result.angle = angle_between(axis, limb);
  result.gradient[1] =
      (-in_frame.z() * frame.col(1) + (in_frame.y() + in_frame.x() * alpha / beta) * frame.col(2)) /
      first.norm();
  result.gradient[2] = -in_frame.x() / beta * frame.col(2);
  result.gradient[0] = -result.gradient[1] - result.gradient[2];
  const Vec3 on_tip = per_square(n.cross(limb), limb);
  result.gradient[3] = -on_tip;
  result.gradient[4] = result.gradient[5] = 0.5 * on_tip;
  return result;
}

double reach_of(const Limit& limit, const Vectors& position) {
  return (position.at(limit.masses[0]) - position.at(limit.masses[1])).norm() / limit.length;
}

LimitAngle reach_gradients(const Limit& limit, const Vectors& position) {
  const Vec3 difference = position.at(limit.masses[0]) - position.at(limit.masses[1]);
  const double distance = difference.norm();
  LimitAngle result;
  result.angle = distance / limit.length;
  result.gradient[0] = (distance > 0.0 ? Vec3(difference / distance) : Vec3(Vec3::UnitX())) / limit.length;
  result.gradient[1] = -result.gradient[0];
  return result;
}

std::array<Index, 3> first_three(const Limit& limit) {
  return {limit.masses[0], limit.masses[1], limit.masses[2]};
}

void gather_repeated(const Limit& limit, LimitAngle& result) {
  for (std::size_t i = 1; i < limit.count; ++i)
    for (std::size_t first = 0; first < i; ++first) {
      if (limit.masses[first] != limit.masses[i]) continue;
      result.gradient[first] += result.gradient[i];
      result.gradient[i].setZero();
      break;
    }
}

}  // namespace

Eigen::Matrix3d frame_axes(const Vec3& o, const Vec3& p, const Vec3& q) {
  Eigen::Matrix3d axes;
  axes.col(0) = (p - o) / (p - o).norm();
  const Vec3 across = axes.col(0).cross(q - o);
  axes.col(2) = across / across.norm();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

double corner_angle(const std::array<Index, 3>& masses, const Vectors& position) {
  const Vec3 b = position.at(masses[1]);
  return angle_between(position.at(masses[0]) - b, position.at(masses[2]) - b);
}

// θ = atan2(|a × c|, a·c). Moving a across its lever, away from c, opens the angle by 1/|a| a metre.
LimitAngle corner_gradients(const std::array<Index, 3>& masses, const Vectors& position) {
  const Vec3 b = position.at(masses[1]);
  const Vec3 a = position.at(masses[0]) - b, c = position.at(masses[2]) - b;
  const Vec3 n = turning_axis(a, c);
  LimitAngle result;
  result.angle = angle_between(a, c);
  result.gradient[0] = per_square(a.cross(n), a);
  result.gradient[2] = per_square(n.cross(c), c);
  result.gradient[1] = -result.gradient[0] - result.gradient[2];
  return result;
}

double limit_angle(const Limit& limit, const Vectors& position) {
  switch (limit.kind) {
    case LimitKind::angle:
      return corner_angle(first_three(limit), position);
    case LimitKind::hinge:
      return bend(hinge_levers(limit, position));
    case LimitKind::cone:
      return angle_between(cone_frame(limit, position) * limit.axis, cone_limb(limit, position));
    case LimitKind::reach:
      return reach_of(limit, position);
  }
  return 0.0;
}

LimitAngle limit_gradients(const Limit& limit, const Vectors& position) {
  LimitAngle result;
  switch (limit.kind) {
    case LimitKind::angle:
      result = corner_gradients(first_three(limit), position);
      break;
    case LimitKind::hinge:
      result = hinge_gradients(limit, position);
      break;
    case LimitKind::cone:
      result = cone_gradients(limit, position);
      break;
    case LimitKind::reach:
      return reach_gradients(limit, position);
  }
  gather_repeated(limit, result);
  return result;
}

Overshoot overshoot(const Limit& limit, double angle) {
  constexpr double circle = 2.0 * std::numbers::pi;
  const double above = angle - limit.max, below = limit.min - angle;
  if (limit.kind == LimitKind::hinge) {
    // Past ±π the other end of the range may be nearer.
    if (above > 0.0 && below + circle < above) return {below + circle, -1.0};
    if (below > 0.0 && above + circle < below) return {above + circle, 1.0};
  }
  return above >= below ? Overshoot{above, 1.0} : Overshoot{below, -1.0};
}

bool has_stop(const Limit& limit, double sign) {
  if (limit.kind == LimitKind::hinge) return true;
  if (limit.kind == LimitKind::reach) return sign > 0.0 ? limit.max < infinite : limit.min > 0.0;
  return sign > 0.0 ? limit.max < std::numbers::pi : limit.min > 0.0;
}

double excess_at(const Limit& limit, double angle, double sign) {
  const double excess = sign > 0.0 ? angle - limit.max : limit.min - angle;
  if (limit.kind != LimitKind::hinge) return excess;
  // What is outside the range belongs to either end by half.
  constexpr double circle = 2.0 * std::numbers::pi;
  const double turned = std::remainder(excess, circle), outside = circle - (limit.max - limit.min);
  return turned > 0.5 * outside ? turned - circle : turned;
}

}  // namespace taut
