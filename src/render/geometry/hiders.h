#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geometry/bodies.h"
#include "geometry/ground_patch.h"

namespace taut {

/// All places within a radius of a box: a ball, a rod, a trunk, a ground.
struct Hider {
  glm::vec3 centre;               ///< m
  std::array<glm::vec3, 3> axes;  ///< unit length
  glm::vec3 halves;               ///< m, of the box along them; 0 where it has none
  float radius;                   ///< m, at the centre
  float taper = 0.0F;             ///< that grows by it for each metre along the first axis
};

Hider hider_of(const TaperedRod& rod);
Hider hider_of(const TorsoRecord& torso);
Hider hider_of(const BoxRecord& box);
/// Where things are that hide anything from what is within a reach (m) of it.
Hider hider_of(const GroundPatch& ground, float reach);

/// From a place to the surface of a hider (m), below 0 inside.
float distance_to(const Hider& hider, const glm::vec3& place);

/// Small flat things on a surface, each with how much is hidden from it.
class ShadedPoints {
 public:
  void clear();
  void add(const glm::vec3& place, const glm::vec3& normal);
  /// Adds what one thing hides: by how large it is seen, how much of that is above the horizon, and the less
  /// the farther it is, nothing from `reach` (m) on.
  void hide_by(const Hider& hider, float reach);

  std::size_t size() const { return hidden_.size(); }
  /// How bright light from all around makes one, 0 to 1.
  float openness(std::size_t point) const;

 private:
  std::array<std::vector<float>, 3> places_, normals_;
  std::vector<float> hidden_;
};

}  // namespace taut
