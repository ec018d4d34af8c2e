#pragma once

#include <string>
#include <vector>

#include "base/vectors.h"
#include "export/export_shape.h"
#include "model/model.h"

namespace taut {

/// A shape as an OBJ file whose vertices are these masses, among them all that the shape is made of; each
/// number with as many digits as tell it from its neighbours (m).
std::string obj_text(const Model& model, const Vectors& position, const ExportShape& shape,
                     const std::vector<Index>& masses);

}  // namespace taut
