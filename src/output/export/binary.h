#pragma once

#include <bit>
#include <string>

#include "base/bytes.h"
#include "base/vectors.h"

namespace taut {

// Every binary format here is little-endian, as append_bytes() is on all machines that taut is built for.
static_assert(std::endian::native == std::endian::little);

/// Appends a vector's three coordinates as single precision.
inline void append_floats(const Vec3& vector, std::string& bytes) {
  for (const double coordinate : {vector.x(), vector.y(), vector.z()})
    append_bytes(static_cast<float>(coordinate), bytes);
}

}  // namespace taut
