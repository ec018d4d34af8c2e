#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "geometry/picture_space.h"
#include "render/ground.h"

namespace taut {

/// The part of a ground that is drawn, a square around the foot of the eye, in picture space.
struct GroundPatch {
  glm::vec3 normal{0, 1, 0};
  glm::vec3 along{1, 0, 0}, across{0, 0, 1};  ///< the grid lines' directions
  float height = 0.0F;                        ///< m, of the eye above it; not above 0 where it isn't seen
  glm::vec2 foot{0.0F};                       ///< m, where in the grid the foot of the eye is
  bool solid = false;
  std::optional<Colour> colour = std::nullopt;  ///< its own, in place of the theme's

  bool operator==(const GroundPatch&) const = default;
};

/// How far above a ground a place is (m).
inline float height_above(const GroundPatch& ground, const glm::vec3& place) {
  return glm::dot(ground.normal, place) + ground.height;
}

/// The patch of a ground whose grid lines pass through the world's origin and repeat at a distance (m).
GroundPatch ground_patch(const Ground& ground, const PictureSpace& space, double period);

}  // namespace taut
