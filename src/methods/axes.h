#pragma once

#include <cstddef>

#include "base/vectors.h"

namespace taut {

/// Where the coordinates of vectors lie that follow each other, for kernels to read …
struct AxesToRead {
  const double *x, *y, *z;
};
/// … and to write.
struct AxesToWrite {
  double *x, *y, *z;
};

/// Those of vectors from one of them on.
inline AxesToRead to_read(const Vectors& vectors, std::size_t begin = 0) {
  return {vectors.x.data() + begin, vectors.y.data() + begin, vectors.z.data() + begin};
}
inline AxesToWrite to_write(Vectors& vectors, std::size_t begin = 0) {
  return {vectors.x.data() + begin, vectors.y.data() + begin, vectors.z.data() + begin};
}

}  // namespace taut
