#pragma once

#include <string>
#include <vector>

#include "model/solid_data.h"
#include "placed_mesh.h"

namespace taut {

/// A placed mesh as a solid; see read_solid().
SolidData solid_of_mesh(const RawMesh& raw, const PlacedMesh& placed, const std::string& file,
                        std::vector<std::string>& notes);

}  // namespace taut
