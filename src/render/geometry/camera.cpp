#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "base/failure.h"
#include "geometry/view_matrices.h"
#include "model/measures.h"

namespace taut {

Vec3 displacement(const std::string& name, const Model& model, const State& start, const State& now) {
  if (name.empty()) return Vec3::Zero();
  const auto& names = model.masses.name;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw BadRequest("the camera can't follow \"" + name + "\": no such mass");
  const auto mass = static_cast<std::size_t>(found - names.begin());
  return now.position.at(mass) - start.position.at(mass);
}

Eigen::AngleAxisd orbit_turn(const Camera& camera, const Vec3& up, double time) {
  return Eigen::AngleAxisd(camera.orbit * time * std::numbers::pi / 180.0, up);
}

Eigen::Matrix3d sight_axes(const Vec3& towards_eye, const Vec3& up) {
  const Vec3 back = towards_eye.normalized();
  Vec3 right = up.cross(back);
  // Straight up or down the vertical is no help: then the third of the upright axes points down the picture.
  if (right.norm() < 1e-6) right = back.cross(upright_axes(up).col(2));
  right.normalize();
  Eigen::Matrix3d axes;
  axes << right, back.cross(right), back;
  return axes;
}

Vec3 up_direction(const Camera& camera, const Model& model) {
  return camera.up ? Vec3(camera.up->stableNormalized()) : up_direction(model);
}

Eigen::Matrix3d upright_axes(const Vec3& up) {
  // Rodrigues' rotation about y × up, written out.
  const double x = up.x(), y = up.y(), z = up.z();
  if (y < -1.0 + 1e-12) return Vec3(1.0, -1.0, -1.0).asDiagonal();
  Eigen::Matrix3d axes;
  axes << 1.0 - x * x / (1.0 + y), x, -x * z / (1.0 + y),  //
      -x, y, -z,                                           //
      -x * z / (1.0 + y), z, 1.0 - z * z / (1.0 + y);
  return axes;
}

CameraPose camera_pose(const Camera& camera, const Model& model, const State& start, const State& now) {
  const Vec3 shift = displacement(camera.follow, model, start, now);
  const Vec3 up = up_direction(camera, model);
  const Vec3 target = camera.target.value();
  const Vec3 arm = orbit_turn(camera, up, now.time) * Vec3(camera.eye.value() - target);
  return {target + arm + shift, target + shift, camera.field_of_view, up};
}

glm::mat4 view_matrix(const CameraPose& pose, const PictureSpace& space) {
  const Eigen::Matrix3d axes = sight_axes(pose.eye - pose.target, pose.up);
  glm::mat4 matrix(1.0F);
  for (int row = 0; row < 3; ++row) {
    const glm::vec3 axis = to_glm(space.direction(axes.col(row)));
    for (int column = 0; column < 3; ++column) matrix[column][row] = axis[column];
  }
  return matrix;
}

glm::mat4 flipped_projection(const CameraPose& pose, Size size, float near, float far) {
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  const float angle = glm::radians(static_cast<float>(pose.field_of_view));
  glm::mat4 projection = glm::perspective(angle, aspect, near, far);
  projection[1][1] = -projection[1][1];
  return projection;
}

Vec3 picture_position(const CameraPose& pose, int width, int height, const Vec3& point) {
  const Vec3 seen = sight_axes(pose.eye - pose.target, pose.up).transpose() * (point - pose.eye);
  const double depth = -seen.z();
  // Pixels for one metre at one metre's distance.
  const double scale = 0.5 * height / std::tan(0.5 * pose.field_of_view * std::numbers::pi / 180.0);
  return {0.5 * width + scale * seen.x() / depth, 0.5 * height - scale * seen.y() / depth, depth};
}

}  // namespace taut
