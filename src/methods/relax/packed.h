#pragma once

namespace taut {

/// A three-vector as the kernels load it: four values side by side, aligned.
template <class Real>
struct alignas(4 * sizeof(Real)) Packed {
  Real x = 0, y = 0, z = 0;
  Real spare = 0;  ///< always 0
};

}  // namespace taut
