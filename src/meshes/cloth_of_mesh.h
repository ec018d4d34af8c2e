#pragma once

#include <string>
#include <vector>

#include "model/description.h"
#include "raw_mesh.h"

namespace taut {

/// A mesh of a file as cloth, placed as its entry says; see read_mesh().
MeshData cloth_of_mesh(const RawMesh& raw, const MeshSpec& spec, std::vector<std::string>& notes);

}  // namespace taut
