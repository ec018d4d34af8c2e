#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace taut {

/// A place of a trunk's skin, in shares of the body's height: x to its left, y up, z forward, from the middle
/// of the hips.
struct TorsoVertex {
  glm::vec3 place;
  glm::vec3 outward;  ///< unit length
};

/// A trunk from between the legs to the neck, one rounded shape: wide at the shoulders, narrower at the
/// waist. Rings of `sides` vertices each from the lower tip to the upper, `bands` + 1 of them.
std::vector<TorsoVertex> torso_vertices(int sides, int bands);

/// Corners of a box around it.
std::array<glm::vec3, 8> torso_corners();

}  // namespace taut
