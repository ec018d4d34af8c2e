#include "geometry/region.h"

#include <algorithm>

#include "geometry/frame_block.h"
#include "geometry/palette.h"
#include "geometry/picture_space.h"
#include "geometry/view_matrices.h"

namespace taut {
namespace {

// A rectangle that grows around the pictures of balls.
class Surrounding {
 public:
  Surrounding(const CameraPose& pose, Size size)
      : to_camera_(view_matrix(pose, PictureSpace(pose))),
        size_(size),
        near_(near_distance(pose)),
        pixels_(1.0F / pixel_height(pose, size)) {}

  void add(const glm::vec3& centre, float radius) {
    const glm::vec3 seen = to_camera_ * glm::vec4(centre, 1.0F);
    const float depth = -seen.z - radius;
    if (!(depth > near_)) {
      behind_ = true;
      return;
    }
    const glm::vec2 place = pixels_ / -seen.z * glm::vec2(seen.x, -seen.y);
    // Off the middle a ball's picture is an ellipse, the longer the farther off.
    const glm::vec2 reach =
        pixels_ * radius / depth * (1.0F + glm::abs(glm::vec2(seen.x, seen.y)) / -seen.z) + 2.0F;
    low_ = glm::min(low_, place - reach);
    high_ = glm::max(high_, place + reach);
  }

  /// Whole where something reaches behind the eye.
  Region region() const {
    if (behind_) return {0, 0, size_.width, size_.height};
    const glm::vec2 size(size_.width, size_.height);
    const glm::vec2 low = glm::clamp(glm::floor(0.5F * size + low_), glm::vec2(0.0F), size);
    const glm::vec2 high = glm::clamp(glm::ceil(0.5F * size + high_), glm::vec2(0.0F), size);
    return {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x - low.x),
            static_cast<int>(high.y - low.y)};
  }

 private:
  glm::mat4 to_camera_;
  Size size_;
  float near_, pixels_;
  bool behind_ = false;
  glm::vec2 low_{1e9F}, high_{-1e9F};
};

}  // namespace

Region around(const Region& a, const Region& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const int left = std::min(a.left, b.left), top = std::min(a.top, b.top);
  return {left, top, std::max(a.left + a.width, b.left + b.width) - left,
          std::max(a.top + a.height, b.top + b.height) - top};
}

Region drawn_region(const Geometry& geometry, Size size) {
  if (geometry.empty()) return {};
  Surrounding surrounding(geometry.pose, size);
  for_each_ball(geometry, [&](const glm::vec3& centre, float radius) { surrounding.add(centre, radius); });
  return surrounding.region();
}

Region shadow_region(const Geometry& geometry, const GroundPatch& ground, Size size, float blur) {
  if (geometry.empty()) return {};
  const glm::vec3 to_light = direction_to_light();
  const float steepness = glm::dot(to_light, ground.normal);
  // Light that grazes the ground or comes from below it throws shadows without an end.
  if (steepness < 0.02F) return {0, 0, size.width, size.height};
  const float near = contact_height(geometry.pose);
  Surrounding surrounding(geometry.pose, size);
  for_each_ball(geometry, [&](const glm::vec3& centre, float radius) {
    const float height = height_above(ground, centre), way = height / steepness;
    const float penumbra = 2.0F * light_spread * std::max(way + radius, 0.0F);
    surrounding.add(centre - to_light * way, (radius + penumbra) / steepness + blur);
    if (ground.solid && height - radius < near)
      surrounding.add(centre - ground.normal * height, radius + 1.5F * near);
  });
  return surrounding.region();
}

bool may_hide(const GroundPatch& ground, const Geometry& geometry) {
  bool below = false;
  for_each_ball(geometry, [&](const glm::vec3& centre, float radius) {
    below = below || height_above(ground, centre) < radius;
  });
  return below;
}

}  // namespace taut
