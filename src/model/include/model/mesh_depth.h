#pragma once

#include <array>

#include "model/solid_mesh.h"

namespace taut {

/// The least distance (m) of any place of a triangle from the surface of a solid, negative inside; both in
/// the solid's axes. Of a triangle that is outside it is exact; of one that the surface goes through, that of
/// the deepest of places a sixteenth of its sides apart.
double least_distance(const SolidMesh& solid, const std::array<Vec3, 3>& corners);

}  // namespace taut
