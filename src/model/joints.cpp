#include "model/joints.h"

#include <algorithm>

namespace taut {
namespace {

Limit hinge(const Joint& joint) {
  Limit limit;
  limit.kind = LimitKind::hinge;
  limit.count = 5;
  limit.masses = joint.masses;
  return limit;
}

// The angle between a direction of the frame and the line from one mass to the middle of two.
Limit cone(const Joint& joint, Index from, Index c, Index d, const Vec3& axis) {
  Limit limit;
  limit.kind = LimitKind::cone;
  limit.count = 6;
  limit.masses = {joint.masses[0], joint.masses[1], joint.masses[2], from, c, d};
  limit.axis = axis;
  return limit;
}

}  // namespace

// The angle between a limb and a direction across it that is fixed in the frame changes by the limb's turn
// about what is across both, and by nothing else. Two directions at right angles give the swing; what lies
// across a limb and its end's width gives the twist.
JointAngles joint_angles(const Joint& joint, const Vectors& position) {
  const auto& [o, p, q, b, c, d] = joint.masses;
  JointAngles result;
  if (joint.kind == JointKind::hinge) {
    result.angles[0] = hinge(joint);
    return result;
  }
  const Eigen::Matrix3d to_frame = frame_axes(position.at(o), position.at(p), position.at(q)).transpose();
  const Vec3 limb = to_frame * (0.5 * (position.at(c) + position.at(d)) - position.at(b));
  if (joint.kind == JointKind::twist) {
    const Vec3 width = to_frame * (position.at(d) - position.at(c));
    result.angles[0] = cone(joint, c, d, d, limb.cross(width).normalized());
    return result;
  }
  result.count = 2;
  result.directions[0] = limb.unitOrthogonal();
  result.directions[1] = limb.normalized().cross(result.directions[0]);
  for (std::size_t k = 0; k < 2; ++k) result.angles[k] = cone(joint, b, c, d, result.directions[k]);
  return result;
}

}  // namespace taut
