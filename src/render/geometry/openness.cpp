#include "geometry/openness.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/occluders.h"
#include "geometry/torso.h"

namespace taut {
namespace {

// How much darker it gets for what is hidden.
constexpr float strength = 1.6F;
// Cloth that bulges is brighter than flat cloth, by so much at most. It sees no more of the sky; but folds
// are read by it.
constexpr float relief = 0.3F;

/// Something thick that is near: where its surface is nearest, and how thick it is there (m).
struct Thick {
  glm::vec3 towards;  ///< from what it hides, of unit length; shorter the deeper that is inside
  float away, radius;
};

/// Calls visit(triangle's area, its corner) for each corner.
template <typename Visit>
void for_each_share(const ClothMasses& cloth, const Visit& visit) {
  for (std::size_t i = 0; i + 2 < cloth.triangles.size(); i += 3) {
    const auto corners = std::span(cloth.triangles).subspan(i, 3);
    const glm::vec3& a = cloth.places[corners[0]];
    const float area =
        0.5F * glm::length(glm::cross(cloth.places[corners[1]] - a, cloth.places[corners[2]] - a));
    for (const Index corner : corners) visit(area, corner);
  }
}

// Of the masses that stand for others, which four times as few are enough for.
std::vector<float> areas_of(const ClothMasses& cloth) {
  std::vector<float> areas(cloth.places.size(), 0.0F);
  for_each_share(cloth, [&](float area, Index mass) { areas[cloth.groups[mass]] += area / 3.0F; });
  return areas;
}

glm::vec2 hidden_by(const Thick& thick, const glm::vec3& normal, float reach) {
  if (thick.away >= reach) return glm::vec2(0.0F);
  const float near = 1.0F - thick.away / reach;
  const float wide = thick.radius / (thick.radius + thick.away);
  const float share = near * near * wide * wide * glm::dot(normal, thick.towards);
  return {std::max(share, 0.0F), std::max(-share, 0.0F)};
}

Thick seen_from(const glm::vec3& place, const glm::vec3& surface, float away, float radius) {
  const glm::vec3 way = surface - place;
  // Cloth that is held by a bar lies on its very axis: nothing there is on one side.
  return {way / std::max(glm::length(way), away > 0.0F ? 1e-9F : radius), std::max(away, 0.0F), radius};
}

Thick near_rod(const glm::vec3& place, const glm::vec3& start, float start_radius, const glm::vec3& end,
               float end_radius) {
  const glm::vec3 span = end - start;
  const float square = glm::dot(span, span);
  const float share = square > 0.0F ? std::clamp(glm::dot(place - start, span) / square, 0.0F, 1.0F) : 0.0F;
  const glm::vec3 middle = start + share * span;
  const float radius = start_radius + share * (end_radius - start_radius);
  return seen_from(place, middle, glm::length(middle - place) - radius, radius);
}

Thick near_box(const glm::vec3& place, const BoxRecord& box) {
  glm::vec3 nearest = box.centre, inwards(0.0F);
  float radius = 1e9F, depth = 1e9F;
  for (const glm::vec3& edge : box.edges) {
    const float half = std::max(glm::length(edge), 1e-9F);
    const glm::vec3 axis = edge / half;
    const float along = glm::dot(place - box.centre, axis);
    nearest += axis * std::clamp(along, -half, half);
    radius = std::min(radius, half);
    if (half - std::abs(along) >= depth) continue;
    depth = half - std::abs(along);
    inwards = along < 0.0F ? axis : -axis;
  }
  const float away = glm::length(nearest - place);
  return away > 1e-3F * radius ? seen_from(place, nearest, away, radius) : Thick{inwards, 0.0F, radius};
}

glm::vec2 hidden_by_all(const Surroundings& around, const glm::vec3& place, const glm::vec3& normal,
                        float reach) {
  glm::vec2 hidden(0.0F);
  for (const TaperedRod& rod : around.bodies.rods)
    hidden += hidden_by(near_rod(place, rod.start, rod.start_radius, rod.end, rod.end_radius), normal, reach);
  for (const TorsoRecord& torso : around.bodies.torsos) {
    const std::array<glm::vec3, 8> corners = torso_corners();
    const float radius = 0.7F * corners[7].x * glm::length(torso.axes[0]);
    const glm::vec3 low = torso.origin + corners[0].y * torso.axes[1];
    const glm::vec3 high = torso.origin + corners[7].y * torso.axes[1];
    hidden += hidden_by(near_rod(place, low, radius, high, radius), normal, reach);
  }
  for (const BoxRecord& box : around.bodies.boxes) hidden += hidden_by(near_box(place, box), normal, reach);
  for (const GroundPatch& ground : around.grounds)
    if (ground.solid)
      hidden += hidden_by({-ground.normal, std::max(height_above(ground, place), 0.0F), 1e9F}, normal, reach);
  return hidden;
}

/// Each mean with its neighbours', so that what is nearer than masses are to each other doesn't speckle.
std::vector<glm::vec2> smoothed(const ClothMasses& cloth, const std::vector<glm::vec2>& values) {
  std::vector<glm::vec3> sums(values.size(), glm::vec3(0.0F));
  for (std::size_t i = 0; i + 2 < cloth.triangles.size(); i += 3) {
    const auto corners = std::span(cloth.triangles).subspan(i, 3);
    glm::vec2 sum(0.0F);
    for (const Index corner : corners) sum += values[corner];
    for (const Index corner : corners) sums[corner] += glm::vec3(sum, 3.0F);
  }
  std::vector<glm::vec2> means = values;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (sums[i].z > 0.0F) means[i] = glm::vec2(sums[i]) / sums[i].z;
  return means;
}

}  // namespace

std::vector<glm::vec2> openness_of(const ClothMasses& cloth, const Surroundings& around, float reach) {
  const std::vector<float> areas = areas_of(cloth);
  const Occluders balls(cloth.places, areas, reach);
  std::vector<glm::vec2> open(cloth.places.size(), glm::vec2(1.0F));
  for (std::size_t mass = 0; mass < open.size(); ++mass) {
    if (cloth.normals[mass] == glm::vec3(0.0F)) continue;
    const glm::vec3& place = cloth.places[mass];
    const glm::vec3& normal = cloth.normals[mass];
    const glm::vec2 by_cloth = balls.hidden(place, normal);
    const glm::vec2 bulging = 1.0F - glm::exp(-strength * glm::vec2(by_cloth.y, by_cloth.x));
    const glm::vec2 hidden = by_cloth + hidden_by_all(around, place, normal, reach);
    open[mass] = glm::exp(-strength * hidden) * (1.0F + relief * bulging);
  }
  return smoothed(cloth, open);
}

}  // namespace taut
