#pragma once

#include "base/vectors.h"

namespace taut {

/// The rotation by degrees about x, then y, then z.
Eigen::Matrix3d turned(const Vec3& degrees);

}  // namespace taut
