#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/bodies.h"
#include "geometry/ground_patch.h"
#include "geometry/surface_records.h"

namespace taut {

/// The masses of cloth in picture space.
struct ClothMasses {
  const std::vector<Index>& triangles;  ///< of what is whole
  const std::vector<glm::vec3>& places;
  const std::vector<glm::vec3>& normals;  ///< unit vectors, on the front side; 0 where there is no cloth
  const std::vector<Index>& groups;       ///< for each mass, one near it that stands for it to others
};

/// What else is near.
struct Surroundings {
  const Bodies& bodies;
  const std::vector<GroundPatch>& grounds;
};

/// How bright light from all around makes the front (x) and the back (y) of each mass of cloth: 1 where
/// nothing is in its way within `reach` (m), down to 0, and a little above 1 where it bulges. In the way are
/// the cloth itself, bodies, solids and grounds: each mass as a ball as large as its share of the triangles,
/// by what it covers of the sky (Bunnell, Dynamic Ambient Occlusion and Indirect Lighting, GPU Gems 2, 2005),
/// less the farther it is.
std::vector<glm::vec2> openness_of(const ClothMasses& cloth, const Surroundings& around, float reach);

}  // namespace taut
