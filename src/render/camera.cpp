#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "base/failure.h"
#include "view_matrices.h"

namespace taut {
namespace {

Vec3 displacement(const std::string& name, const Model& model, const State& start, const State& now) {
  if (name.empty()) return Vec3::Zero();
  const auto& names = model.masses.name;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw BadRequest("the camera can't follow \"" + name + "\": no such mass");
  const auto mass = static_cast<std::size_t>(found - names.begin());
  return now.position.at(mass) - start.position.at(mass);
}

Vec3 turned_about_vertical(const Vec3& v, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() + s * v.z(), v.y(), -s * v.x() + c * v.z()};
}

}  // namespace

CameraPose camera_pose(const Camera& camera, const Model& model, const State& start, const State& now) {
  const Vec3 shift = displacement(camera.follow, model, start, now);
  const Vec3 arm = turned_about_vertical(camera.eye - camera.target, camera.orbit * now.time);
  return {camera.target + arm + shift, camera.target + shift, camera.field_of_view};
}

glm::mat4 view_matrix(const CameraPose& pose) {
  const Vec3 sight = pose.target - pose.eye;
  // Straight up or down the vertical is no help: then −z is the picture's top.
  const bool vertical = std::hypot(sight.x(), sight.z()) < 1e-6 * sight.norm();
  const glm::vec3 up = vertical ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  return glm::lookAt(to_glm(pose.eye), to_glm(pose.target), up);
}

glm::mat4 flipped_projection(const CameraPose& pose, Size size, float near, float far) {
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  const float angle = glm::radians(static_cast<float>(pose.field_of_view));
  glm::mat4 projection = glm::perspective(angle, aspect, near, far);
  projection[1][1] = -projection[1][1];
  return projection;
}

Vec3 picture_position(const CameraPose& pose, int width, int height, const Vec3& point) {
  const glm::vec4 seen = view_matrix(pose) * glm::vec4(to_glm(point), 1.0F);
  const double depth = -static_cast<double>(seen.z);
  // Pixels for one metre at one metre's distance.
  const double scale = 0.5 * height / std::tan(0.5 * pose.field_of_view * std::numbers::pi / 180.0);
  return {0.5 * width + scale * static_cast<double>(seen.x) / depth,
          0.5 * height - scale * static_cast<double>(seen.y) / depth, depth};
}

}  // namespace taut
