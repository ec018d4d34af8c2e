#pragma once

#include <glm/glm.hpp>
#include <type_traits>
#include <vector>

#include "geometry/mesh_topology.h"

namespace taut {

/// The vertices of meshes as they are seen, in the topology's order: `masses` (m) in picture space, which
/// `to_picture` turns the world's axes to, and `at_start` in the world's axes. Triangles are rounded by the
/// normals at their corners (Boubekeur and Alexa, Phong Tessellation, 2008), and what lies along tears is
/// turned as the mass that it hangs on. `normals` of all masses of the meshes are written too.
std::vector<SurfaceVertex> mesh_vertices(const MeshCloth& cloth, const MeshTopology& topology,
                                         const std::vector<glm::vec3>& masses,
                                         const std::vector<glm::vec3>& at_start, const glm::mat3& to_picture,
                                         std::vector<glm::vec3>& normals);

/// A part of so many, in each component of a value.
template <class Value>
Value share_as(Index part, Index parts) {
  if constexpr (std::is_same_v<Value, double>)
    return static_cast<double>(part) / static_cast<double>(parts);
  else
    return Value(static_cast<float>(part) / static_cast<float>(parts));
}

/// What masses have, for each vertex of meshes: between corners in proportion, on torn triangles that of the
/// corner.
template <class Value>
void add_mesh_values(const MeshCloth& cloth, const MeshTopology& topology, const std::vector<Value>& of_mass,
                     std::vector<Value>& values) {
  const Index parts = cloth.parts;
  for (const Index triangle : topology.whole) {
    const auto& [a, b, c] = cloth.triangles[triangle].masses;
    for (Index down = 0; down <= parts; ++down)
      for (Index across = 0; across + down <= parts; ++across) {
        const auto right = share_as<Value>(across, parts);
        const auto below = share_as<Value>(down, parts);
        values.push_back(of_mass[a] + right * (of_mass[b] - of_mass[a]) + below * (of_mass[c] - of_mass[a]));
      }
  }
  for (const TornVertex& vertex : topology.torn_vertices)
    values.push_back(of_mass[cloth.triangles[topology.torn[vertex.torn].triangle].masses[vertex.corner]]);
}

}  // namespace taut
