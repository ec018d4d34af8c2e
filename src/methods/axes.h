#pragma once

#include <array>
#include <cstddef>

#include "base/vectors.h"

namespace taut {

/// Where the x, y and z of vectors lie that follow each other, for kernels to read …
using AxesToRead = std::array<const double*, 3>;
/// … and to write.
using AxesToWrite = std::array<double*, 3>;

/// Those of vectors from one of them on.
inline AxesToRead to_read(const Vectors& vectors, std::size_t begin = 0) {
  return {vectors.x.data() + begin, vectors.y.data() + begin, vectors.z.data() + begin};
}
inline AxesToWrite to_write(Vectors& vectors, std::size_t begin = 0) {
  return {vectors.x.data() + begin, vectors.y.data() + begin, vectors.z.data() + begin};
}

}  // namespace taut
