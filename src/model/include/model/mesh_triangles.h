#pragma once

#include <array>
#include <vector>

#include "model/mesh_data.h"

namespace taut {

/// How each face is cut into triangles, by its corners: one of a triangle, two of a quad, along its shorter
/// diagonal, or the one that lies within.
std::vector<std::array<Index, 3>> triangles_of(const MeshData& mesh, std::size_t face);

}  // namespace taut
