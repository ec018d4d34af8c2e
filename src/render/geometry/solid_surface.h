#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "geometry/colour_scale.h"
#include "model/solid_mesh.h"

namespace taut {

/// A vertex of a solid out of a mesh, in its own axes, as shaders/solid.vert reads it.
struct SolidVertex {
  glm::vec3 position;  ///< m
  glm::vec3 normal;    ///< unit length, out of the solid
};

/// What is drawn of a solid out of a mesh: the same in every picture.
struct SolidSurface {
  std::vector<SolidVertex> vertices;
  std::vector<Index> triangles;  ///< three vertices each
};

/// The surface of a mesh: smooth over edges that are bent by less than 40°, with a crease over others.
SolidSurface solid_surface(const SolidMesh& mesh);

/// A solid out of a mesh where it is drawn.
struct MeshRecord {
  std::shared_ptr<const SolidSurface> surface;
  glm::vec3 centre;   ///< m
  glm::vec3 axes[3];  ///< unit length
  Rgba colour;
  int shade =
      -1;  ///< the first row of ShadeTiles with a texel for each vertex; below 0 where nothing is near
};

}  // namespace taut
