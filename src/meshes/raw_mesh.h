#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// A mesh as it stands in a file.
struct RawMesh {
  std::vector<Vec3> vertices;
  std::vector<Index> corners;  ///< of all faces, one face after another; checked to be vertices
  std::vector<Index> face_begin{
      0};  ///< where each face's corners begin in that, and where the last one's end
  std::vector<std::size_t> vertex_line, face_line;  ///< in the file, from 1; empty where it has no lines
  std::vector<std::string> groups;
  std::vector<std::array<Index, 2>> face_groups;  ///< a face, and a group that it is in

  std::size_t face_count() const { return face_begin.size() - 1; }
};

/// `cloth.obj:12`, or `cloth.obj` where a file has no lines.
std::string place_in(std::string_view called, const std::vector<std::size_t>& lines, std::size_t number);

/// A mesh out of the text of an OBJ file: its vertices, faces, groups, objects and materials. Throws
/// BadRequest with the line of what is wrong.
RawMesh parse_obj(std::string_view text, const std::string& called);

/// A mesh out of the bytes of a PLY file, and of an STL file of bytes or of text, of which each named solid
/// is a group. Throws BadRequest.
RawMesh parse_ply(const std::string& bytes, const std::string& called);
RawMesh parse_stl(std::string_view bytes, const std::string& called);

}  // namespace taut
