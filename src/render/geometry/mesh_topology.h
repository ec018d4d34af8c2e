#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "geometry/mesh_cloth.h"

namespace taut {

/// A vertex of a triangle that is torn, as one of its corners sees it: of the cloth that stays with the
/// corner.
struct TornVertex {
  Index torn = 0;          ///< in MeshTopology::torn
  Index corner = 0;        ///< 0, 1 or 2
  glm::vec3 share{0.0F};   ///< of each corner in its place, 1 together
  float from_tear = 0.0F;  ///< 0 on a torn edge, 1 at the corner
  bool middle = false;     ///< that all corners share which whole edges join
};

/// A triangle with a broken edge.
struct TornTriangle {
  Index triangle = 0;            ///< in MeshCloth::triangles
  std::array<bool, 3> broken{};  ///< from each corner to the next
};

/// A mass beside a tear, and those that whole edges lead to: they say how it has turned.
struct TornMass {
  Index mass = 0;
  std::vector<Index> beside;
};

/// What of the meshes is drawn, for as long as nothing tears. Vertices: those of each whole triangle, then
/// those of torn ones.
struct MeshTopology {
  std::vector<Index> whole;  ///< numbers of triangles
  std::vector<TornTriangle> torn;
  std::vector<TornVertex> torn_vertices;
  std::vector<TornMass> torn_masses;  ///< rising
  SharedIndices block_vertices;  ///< of each triangle's block: the vertices that light is looked up for, of
                                 ///< all vertices of the cloth, as vertices_a_triangle() of a whole one
};

/// Adds the triangles of meshes to `indices`, their vertices' places to `places`, behind those that are
/// there.
MeshTopology mesh_topology(const MeshCloth& cloth, const MeshBlocks& blocks, const std::vector<bool>& broken,
                           std::vector<SurfacePlace>& places, std::vector<Index>& indices);

}  // namespace taut
