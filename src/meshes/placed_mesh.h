#pragma once

#include <string>
#include <vector>

#include "model/description.h"
#include "raw_mesh.h"

namespace taut {

/// What a mesh is read for: cloth may have borders, a solid has none.
enum class MeshUse { cloth, solid };

/// A mesh of a file, placed, and which face of the file each of its faces was.
struct PlacedMesh {
  MeshData data;
  std::vector<Index> from;
};

/// A mesh of a file as cloth or as the surface of a solid, placed as its entry says; see read_mesh() and
/// read_solid().
PlacedMesh placed_mesh(const RawMesh& raw, const MeshSpec& spec, MeshUse use,
                       std::vector<std::string>& notes);

}  // namespace taut
