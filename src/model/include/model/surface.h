#pragma once

#include "base/vectors.h"

namespace taut {

/// Where a solid's surface is, seen from a point.
struct Surface {
  double distance = 0.0;        ///< m; negative inside
  Vec3 normal = Vec3::UnitY();  ///< unit length, out of the solid
};

}  // namespace taut
