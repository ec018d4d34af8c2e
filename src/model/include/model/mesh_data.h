#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// Which axis of a mesh file points upwards.
enum class UpAxis : std::uint8_t { y, z };

/// A surface as it is read from a file and placed in a scene: every corner is there once, and used; no edge
/// has more than two faces; neighbours run around alike where that can be; faces have three corners or four.
struct MeshData {
  std::vector<Vec3> vertices;  ///< m
  std::vector<Index> corners;  ///< of all faces, one face after another
  std::vector<Index> face_begin{
      0};                           ///< where each face's corners begin in that, and where the last one's end
  std::vector<std::string> groups;  ///< names of groups, objects and materials
  std::vector<std::vector<Index>> group_vertices;  ///< of each group, rising
  Index pieces = 1;                                ///< that hang together by edges

  std::size_t face_count() const { return face_begin.size() - 1; }
  std::span<const Index> face(std::size_t number) const {
    return std::span(corners).subspan(face_begin[number], face_begin[number + 1] - face_begin[number]);
  }
};

}  // namespace taut
