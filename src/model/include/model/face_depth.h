#pragma once

#include <array>

#include "model/colliders.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The least distance (m) of any place of a triangle from the surface of a solid, negative inside.
double least_distance(const Shape& shape, const std::array<Vec3, 3>& corners);

/// Whether any place of a triangle may be nearer to the surface of a solid than `reach` (m): quickly said of
/// most that aren't.
bool may_be_within(double reach, const Shape& shape, const std::array<Vec3, 3>& corners);

/// How deep (m) the deepest face is within half its thickness of a solid, or two faces that touch within the
/// thickness that keeps them apart; 0 where nothing is.
double deepest_face(const Model& model, const State& state);

}  // namespace taut
