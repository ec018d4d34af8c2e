#pragma once

#include <vector>

#include "base/vectors.h"

namespace taut {

/// Where a mass was at a time.
struct TrailPoint {
  double time = 0.0;          ///< s
  Vec3 place = Vec3::Zero();  ///< m
};

/// The ways of some masses so far, each from the oldest point to the newest.
using Trails = std::vector<std::vector<TrailPoint>>;

}  // namespace taut
