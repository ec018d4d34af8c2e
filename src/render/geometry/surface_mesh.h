#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "geometry/colour_scale.h"
#include "geometry/openness.h"
#include "geometry/picture_space.h"
#include "geometry/surface_topology.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Vertices and triangles, in the topology's order.
struct SurfaceMesh {
  std::vector<SurfaceVertex> vertices;
  std::vector<Rgba> colours;       ///< in place of the cloth's own; empty where masses have none
  std::vector<SurfaceTint> tints;  ///< empty where all sheets have the look's colours
  SharedPlaces places;
  std::shared_ptr<const SpreadSheets> spread;
  SharedIndices indices;
  SharedIndices block_vertices;  ///< MeshTopology::block_vertices
};

/// The mesh of a state as it is seen in a picture space. Normals are smoothed over the triangles about each
/// vertex; what hides light from the cloth is worked out for each mass, where the cloth has colours of its
/// own.
SurfaceMesh surface_mesh(const Cloth& cloth, const SurfaceTopology& topology, const State& seen,
                         const PictureSpace& space, const Quantity& quantity, const ColourScale& scale,
                         const Surroundings& around);

/// For each place of spread sheets, row by row, where the shadow map is to be looked up for it, and the depth
/// that light must reach there. `to_map` takes picture space to the map, `to_light` is a unit vector, and
/// `texel` (m) the map's: by that much places are lifted off their own shadow, towards the side that is lit.
std::vector<glm::vec4> light_places(const SurfaceMesh& mesh, const glm::mat4& to_map,
                                    const glm::vec3& to_light, float texel);

}  // namespace taut
