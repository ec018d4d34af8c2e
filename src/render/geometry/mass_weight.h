#pragma once

#include <vector>

#include "model/model.h"
#include "view/view.h"

namespace taut {

/// How weight is seen: 1 for a mass as heavy as the median of those that are free and no part of a ragdoll,
/// and for pins.
struct MassWeight {
  double size = 1.0;   ///< times the radius: the cube root of the share of the median, from 0.35 to 6
  double shade = 1.0;  ///< times the colour: below 1 for the heavier, at least 0.3
};

/// One a mass; all alike where the look shows no weights.
std::vector<MassWeight> mass_weights(const Model& model, const Look& look);

}  // namespace taut
