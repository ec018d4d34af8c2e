#pragma once

#include <vector>

#include "base/vectors.h"

namespace taut {

/// For each place the first one that is no farther from it than a distance (m) and stands for itself; itself
/// where there is none. In time that grows as their number.
std::vector<Index> welded(const std::vector<Vec3>& places, double distance);

}  // namespace taut
