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
  glm::vec3 low(1e30F), high(-1e30F);
  for (const glm::vec3& corner : corners(geometry.bounds)) {
    const glm::vec3 seen = turn * glm::vec4(corner, 1.0F);
    low = glm::min(low, seen);
    high = glm::max(high, seen);
  }
  // Square, of few sizes, and moved by whole texels only, so that edges of shadows stay still.
  const float map_width = 1.02F * rung_above(std::max({high.x - low.x, high.y - low.y, 1e-3F}));
  const float texel = map_width / static_cast<float>(map_size);
  const glm::dvec3 fixed = glm::dmat4(turn) * glm::dvec4(geometry.anchor, 1.0);
  const glm::dvec2 steps = glm::floor((0.5 * glm::dvec2(low + high) - glm::dvec2(fixed)) / double(texel));
  const glm::vec2 middle(glm::dvec2(fixed) + steps * double(texel));
  const float half = 0.5F * map_width;
  const float slack = 0.01F * (high.z - low.z) + 4.0F * texel;
  const glm::mat4 projection = glm::ortho(middle.x - half, middle.x + half, middle.y - half, middle.y + half,
                                          -high.z - slack, -low.z + slack);
  FrameBlock block;
  block.view_projection = projection * turn;
  // Far enough that lines of sight are as good as parallel to the light.
  const glm::vec3 centre = 0.5F * (geometry.bounds.low + geometry.bounds.high);
  block.eye = glm::vec4(centre + to_light * (1000.0F * map_width), 1.0F);
  block.forward = glm::vec4(-to_light, 0.0F);
  block.shadow = {0.0F, 1.0F / static_cast<float>(map_size), texel, 0.0F};
  return block;
}

void add_shadow(FrameBlock& camera, const FrameBlock& light) {
  const glm::mat4 to_unit =
      glm::translate(glm::mat4(1.0F), glm::vec3(0.5F)) * glm::scale(glm::mat4(1.0F), glm::vec3(0.5F));
  camera.shadow_matrix = to_unit * light.view_projection;
  camera.shadow = {1.0F, light.shadow.y, light.shadow.z, 0.0F};
}

}  // namespace taut
