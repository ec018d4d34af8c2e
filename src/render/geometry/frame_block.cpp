#include "geometry/frame_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/palette.h"
#include "geometry/picture_space.h"
#include "geometry/view_matrices.h"

namespace taut {
namespace {

std::array<glm::vec3, 8> corners(const DrawnBox& bounds) {
  std::array<glm::vec3, 8> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = {(i & 1U) != 0 ? bounds.high.x : bounds.low.x, (i & 2U) != 0 ? bounds.high.y : bounds.low.y,
              (i & 4U) != 0 ? bounds.high.z : bounds.low.z};
  }
  return all;
}

/// The nearest of …, 0.1, 0.25, 0.5, 1, 2.5, … at or below a length.
float round_spacing(float length) {
  const float decade = std::pow(10.0F, std::floor(std::log10(length)));
  const float share = length / decade;
  return decade * (share >= 5.0F ? 5.0F : share >= 2.5F ? 2.5F : 1.0F);
}

/// The next of a ladder of sizes, eight a doubling: a map that changes size rarely doesn't shimmer.
float rung_above(float length) {
  return std::exp2(std::ceil(8.0F * std::log2(length)) / 8.0F);
}

DrawnBox bounds_after(const glm::mat4& turn, const DrawnBox& bounds) {
  DrawnBox after{glm::vec3(1e30F), glm::vec3(-1e30F)};
  for (const glm::vec3& corner : corners(bounds)) {
    const glm::vec3 seen = turn * glm::vec4(corner, 1.0F);
    after.low = glm::min(after.low, seen);
    after.high = glm::max(after.high, seen);
  }
  return after;
}

/// What a map shows, in the axes that it is seen in (m).
struct Square {
  glm::vec2 middle;
  float width, texel;
};

/// Of few sizes, and moved only by so many texels as masks average, which keep to a place, so that edges of
/// shadows stay still.
Square square_around(const DrawnBox& seen, float least_width, int map_size, const glm::dvec3& fixed) {
  const float width = rung_above(least_width);
  const float texel = width / static_cast<float>(map_size);
  const double step = double(texel) * mask_span;
  const glm::dvec2 steps = glm::round((0.5 * glm::dvec2(seen.low + seen.high) - glm::dvec2(fixed)) / step);
  return {glm::vec2(glm::dvec2(fixed) + steps * step), width, texel};
}

/// A pass seen by parallel lines of sight in turned axes, between two distances along them (m).
FrameBlock parallel_block(const Geometry& geometry, const glm::mat4& turn, const Square& square, float near,
                          float far) {
  const glm::vec2 low = square.middle - 0.5F * square.width, high = square.middle + 0.5F * square.width;
  const glm::vec3 back(turn[0][2], turn[1][2], turn[2][2]);
  FrameBlock block;
  block.view_projection = glm::ortho(low.x, high.x, low.y, high.y, near, far) * turn;
  // Far enough that lines of sight are as good as parallel.
  const glm::vec3 centre = 0.5F * (geometry.bounds.low + geometry.bounds.high);
  block.eye = glm::vec4(centre + back * (1000.0F * square.width), 1.0F);
  block.forward = glm::vec4(-back, 0.0F);
  block.shadow = {0.0F, square.texel / square.width, square.texel, square.width / (far - near)};
  return block;
}

}  // namespace

float reach_of(const CameraPose& pose) {
  return std::max(static_cast<float>((pose.target - pose.eye).norm()), 1e-6F);
}

double grid_spacing(const CameraPose& pose) {
  return double(round_spacing(reach_of(pose) / 16.0F));
}

float pixel_height(const CameraPose& pose, Size size) {
  const float half_angle = 0.5F * glm::radians(static_cast<float>(pose.field_of_view));
  return 2.0F * std::tan(half_angle) / static_cast<float>(size.height);
}

float near_distance(const CameraPose& pose) {
  return 0.01F * reach_of(pose);
}

FrameBlock camera_block(const Geometry& geometry, Size size, const glm::vec2& shift) {
  const CameraPose& pose = geometry.pose;
  const PictureSpace space(pose);
  const float reach = reach_of(pose);
  const glm::vec3 forward = to_glm(space.place(pose.target)) / reach;
  const float fog_start = 1.1F * reach, fog_end = 3.6F * reach;
  float far = 1.6F * fog_end;
  for (const glm::vec3& corner : corners(geometry.bounds)) {
    far = std::max(far, 1.1F * glm::dot(corner, forward));
  }
  const float near = near_distance(pose);

  FrameBlock block;
  const glm::vec3 shift_in_clip_space(2.0F * shift.x / static_cast<float>(size.width),
                                      2.0F * shift.y / static_cast<float>(size.height), 0.0F);
  block.view_projection = glm::translate(glm::mat4(1.0F), shift_in_clip_space) *
                          flipped_projection(pose, size, near, far) * view_matrix(pose, space);
  block.eye = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
  block.forward = glm::vec4(forward, 0.0F);
  block.fog = {fog_start, fog_end, static_cast<float>(grid_spacing(pose)), 0.0F};
  block.view.x = pixel_height(pose, size);
  return block;
}

FrameBlock light_block(const Geometry& geometry, int map_size) {
  const glm::vec3 to_light = direction_to_light();
  const glm::mat4 turn = glm::lookAt(glm::vec3(0.0F), -to_light, glm::vec3(0, 1, 0));
  const DrawnBox seen = bounds_after(turn, geometry.bounds);
  const glm::vec3 size = seen.high - seen.low;
  const Square square = square_around(seen, 1.02F * std::max({size.x, size.y, 1e-3F}), map_size,
                                      glm::dvec3(glm::dmat4(turn) * glm::dvec4(geometry.anchor, 1.0)));
  const float slack = 0.01F * size.z + 4.0F * square.texel;
  return parallel_block(geometry, turn, square, -seen.high.z - slack, -seen.low.z + slack);
}

float contact_height(const CameraPose& pose) {
  return 0.08F * reach_of(pose);
}

float shade_reach(const CameraPose& pose) {
  return 0.04F * reach_of(pose);
}

FrameBlock contact_block(const Geometry& geometry, const GroundPatch& ground, int map_size) {
  const glm::mat4 turn = glm::lookAt(glm::vec3(0.0F), ground.normal, ground.across);
  const DrawnBox seen = bounds_after(turn, geometry.bounds);
  const glm::vec3 size = seen.high - seen.low;
  const float height = contact_height(geometry.pose);
  const Square square =
      square_around(seen, 1.02F * std::max({size.x, size.y, 1e-3F}) + 2.0F * height, map_size,
                    glm::dvec3(glm::dmat4(turn) * glm::dvec4(geometry.anchor, 1.0)));
  return parallel_block(geometry, turn, square, -ground.height - height, -ground.height + height);
}

glm::mat4 to_unit() {
  return glm::translate(glm::mat4(1.0F), glm::vec3(0.5F)) * glm::scale(glm::mat4(1.0F), glm::vec3(0.5F));
}

void add_shadow(FrameBlock& camera, const FrameBlock& light) {
  camera.shadow_matrix = to_unit() * light.view_projection;
  camera.shadow = {1.0F, light.shadow.y, light.shadow.z, light.shadow.w};
}

}  // namespace taut
