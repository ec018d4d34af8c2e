#pragma once

#include "model/colliders.h"
#include "model/state.h"
#include "render/camera.h"

namespace taut {

/// Where things are drawn: seen from the eye, y up. Places are taken there in double precision, so that what
/// is near the eye is as exact in single precision far from the world's origin as at it, and what draws knows
/// one way up only.
class PictureSpace {
 public:
  explicit PictureSpace(const CameraPose& pose)
      : eye_(pose.eye), to_picture_(upright_axes(pose.up).transpose()) {}

  Vec3 place(const Vec3& world) const { return to_picture_ * (world - eye_); }
  Vec3 direction(const Vec3& world) const { return to_picture_ * world; }

  /// As much of a state as is drawn: places of the masses, and which links are broken.
  State seen(const State& state) const;
  Shape seen(const Shape& shape) const;

 private:
  Vec3 eye_;
  Eigen::Matrix3d to_picture_;
};

}  // namespace taut
