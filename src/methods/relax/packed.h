#pragma once

#include "base/vectors.h"

namespace taut {

/// A three-vector as the kernels load it: four values side by side, aligned.
template <class Real>
struct alignas(4 * sizeof(Real)) Packed {
  Real x = 0, y = 0, z = 0;
  Real spare = 0;  ///< always 0
};

/// A vector so, rounded.
template <class Real>
Packed<Real> packed_vector(const Vec3& vector) {
  return {static_cast<Real>(vector.x()), static_cast<Real>(vector.y()), static_cast<Real>(vector.z()),
          Real(0)};
}

}  // namespace taut
