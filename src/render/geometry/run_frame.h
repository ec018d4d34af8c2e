#pragma once

#include <vector>

#include "base/vectors.h"

namespace taut {

/// A unit vector across each of a row of directions (unit vectors), turned with them by as little as can be:
/// what is drawn around a run doesn't wind about it. The first is the same for the same first direction.
std::vector<Vec3> carried_normals(const std::vector<Vec3>& directions);

}  // namespace taut
