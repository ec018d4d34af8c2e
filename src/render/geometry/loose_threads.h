#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/surface_mesh.h"
#include "view/view.h"

namespace taut {

/// Threads that hang from some of the broken links, in the cloth's colours: from where the link is cut they
/// go on its way, and then sag along `down` (a unit vector, or none without gravity). Which ones there are,
/// and how long, is the same in every picture.
std::vector<RodRecord> loose_threads(const Cloth& cloth, const SurfaceTopology& topology,
                                     const SurfaceMesh& mesh, const State& seen, const glm::vec3& down,
                                     const Look& look);

}  // namespace taut
