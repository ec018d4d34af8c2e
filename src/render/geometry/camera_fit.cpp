#include "render/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace taut {

CameraFit::CameraFit(const Eigen::Matrix3d& axes, double field_of_view, double aspect, double margin,
                     const std::optional<Vec3>& centre)
    : axes_(axes) {
  const double slope = (1.0 - 2.0 * margin) * std::tan(0.5 * field_of_view * std::numbers::pi / 180.0);
  slope_ = {slope * aspect, slope};
  reach_ = {std::hypot(1.0, slope_[0]), std::hypot(1.0, slope_[1])};
  if (centre) centre_ = axes.transpose() * *centre;
}

// With the eye at e, a ball at p of radius r is within the right edge where
//   p_x − e_x + slope (p_z − e_z) + r √(1 + slope²) ≤ 0,
// and likewise for the other three.
void CameraFit::add(const Vec3& place, double radius) {
  const Vec3 at = axes_.transpose() * place;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double across = at[static_cast<Eigen::Index>(axis)];
    const double depth = slope_[axis] * at.z() + radius * reach_[axis];
    plus_[axis] = std::max(plus_[axis], across + depth);
    minus_[axis] = std::max(minus_[axis], depth - across);
  }
  nearest_ = std::max(nearest_, at.z() + radius);
  farthest_ = std::min(farthest_, at.z() - radius);
}

CameraFit::Place CameraFit::place(double least_distance) const {
  Vec3 eye(0.0, 0.0, nearest_ + least_distance);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // Both edges are met where 2 slope e_z is the sum of the two, and e_x half their difference.
    const double middle =
        centre_ ? (*centre_)[static_cast<Eigen::Index>(axis)] : 0.5 * (plus_[axis] - minus_[axis]);
    const double depth = std::max(plus_[axis] - middle, minus_[axis] + middle) / slope_[axis];
    eye[static_cast<Eigen::Index>(axis)] = middle;
    eye.z() = std::max(eye.z(), depth);
  }
  const double target = centre_ ? centre_->z() : 0.5 * (nearest_ + farthest_);
  // A target that is nearer than the eye's own place would turn the picture round.
  const Vec3 seen(eye.x(), eye.y(), std::min(target, eye.z() - least_distance));
  return {axes_ * eye, axes_ * seen};
}

}  // namespace taut
