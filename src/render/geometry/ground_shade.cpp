#include "geometry/ground_shade.h"

#include <algorithm>
#include <cmath>

#include "geometry/palette.h"

namespace taut {
namespace {

// How far around what hides the sky it is hidden, in heights up to which things do: in part, and closer.
constexpr float spread_of_sky = 0.5F, closer_spread = 0.15F;

float highest(const Geometry& geometry, const GroundPatch& ground) {
  float height = 0.0F;
  for (int i = 0; i < 8; ++i) {
    const glm::bvec3 high((i & 1) != 0, (i & 2) != 0, (i & 4) != 0);
    height =
        std::max(height, height_above(ground, glm::mix(geometry.bounds.low, geometry.bounds.high, high)));
  }
  return height;
}

// How deep (m) a map is, from depth 0 to 1.
float depth_of(const glm::mat4& to_map) {
  return 1.0F / glm::length(glm::vec3(to_map[0][2], to_map[1][2], to_map[2][2]));
}

float metres_across(const glm::mat4& to_map) {
  return 1.0F / glm::length(glm::vec3(to_map[0][0], to_map[1][0], to_map[2][0]));
}

// Sets which texels anything of the geometry is in.
void find_part(GroundMask& mask, const Geometry& geometry, const glm::mat4& to_map, int size) {
  glm::vec2 low(1.0F), high(0.0F);
  const float metre = 1.0F / metres_across(to_map);
  for_each_ball(geometry, [&](const glm::vec3& centre, float radius) {
    const glm::vec2 place = to_map * glm::vec4(centre, 1.0F);
    low = glm::min(low, place - metre * radius);
    high = glm::max(high, place + metre * radius);
  });
  const auto texels = static_cast<float>(size);
  mask.corner = glm::clamp(glm::ivec2(glm::floor(low * texels)) - 1, 0, size);
  mask.part = glm::clamp(glm::ivec2(glm::ceil(high * texels)) + 1, 0, size) - mask.corner;
}

}  // namespace

GroundMask mask_of_light(const Geometry& geometry, const GroundPatch& ground, const FrameBlock& camera,
                         int size) {
  // Planes turn with the inverse transpose.
  const glm::vec4 plane =
      glm::transpose(glm::inverse(camera.shadow_matrix)) * glm::vec4(ground.normal, ground.height);
  const float farthest =
      std::max(highest(geometry, ground) / glm::dot(direction_to_light(), ground.normal), 1e-6F);
  const float texel = metres_across(camera.shadow_matrix) / static_cast<float>(size);
  GroundMask mask;
  mask.plane = -glm::vec3(plane.x, plane.y, plane.w) / plane.z;
  mask.range = {-depth_of(camera.shadow_matrix), farthest, 0.0F};
  mask.reach = {farthest * light_spread / texel, 0.6F, 0.0F};
  find_part(mask, geometry, camera.shadow_matrix, size);
  return mask;
}

GroundMask mask_of_sky(const Geometry& geometry, const GroundPatch& ground, const FrameBlock& contact,
                       int size) {
  const float height = contact_height(geometry.pose);
  // Clip space is 2 wide.
  const float width = 2.0F * metres_across(contact.view_projection);
  const glm::vec4 foot = contact.view_projection * glm::vec4(-ground.normal * ground.height, 1.0F);
  GroundMask mask;
  mask.plane = {0.0F, 0.0F, 0.5F};
  mask.range = {2.0F * height, height, 0.0F};
  const float height_in_texels = height * static_cast<float>(size) / width;
  mask.reach = {std::max(spread_of_sky * height_in_texels, 0.6F),
                std::max(closer_spread * height_in_texels, 0.6F), 0.0F};
  find_part(mask, geometry, to_unit() * contact.view_projection, size);
  mask.place = {0.5F + 0.5F * foot.x, 0.5F + 0.5F * foot.y, 1.0F / width};
  return mask;
}

bool takes_shadows(const GroundPatch& ground) {
  return glm::dot(direction_to_light(), ground.normal) > 0.02F;
}

bool is_near(const GroundPatch& ground, const Geometry& geometry) {
  const float height = contact_height(geometry.pose);
  bool near = false;
  for_each_ball(geometry, [&](const glm::vec3& centre, float radius) {
    near = near || height_above(ground, centre) - radius < height;
  });
  return near;
}

Reduced reduced(const Region& part, Size picture) {
  Reduced made;
  made.picture = {(picture.width + 1) / 2, (picture.height + 1) / 2};
  made.scale = glm::vec2(made.picture.width, made.picture.height) / glm::vec2(picture.width, picture.height);
  const glm::vec2 low = glm::vec2(part.left, part.top) * made.scale;
  const glm::vec2 high = glm::vec2(part.left + part.width, part.top + part.height) * made.scale;
  made.corner = glm::max(glm::ivec2(glm::floor(low)) - 1, 0);
  // Nothing is drawn beyond the picture's edge.
  const glm::ivec2 size =
      glm::min(glm::ivec2(glm::ceil(high)) + 1, glm::ivec2(made.picture.width, made.picture.height)) -
      made.corner;
  made.part = {size.x, size.y};
  made.start = low - glm::vec2(made.corner);
  return made;
}

}  // namespace taut
