#pragma once

#include <string>
#include <vector>

#include "cloth_of_mesh.h"
#include "model/solid_data.h"

namespace taut {

/// A placed mesh as a solid; see read_solid().
SolidData solid_of_mesh(const RawMesh& raw, const PlacedMesh& placed, const std::string& file,
                        std::vector<std::string>& notes);

}  // namespace taut
