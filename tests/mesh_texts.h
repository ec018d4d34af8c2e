#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>

#include "base/failure.h"
#include "meshes/read_mesh.h"
#include "temporary_folder.h"

namespace taut::testing {

/// A square of two triangles, in each format: 1 m wide, in the plane z = 0.
inline const std::string square_obj = "# a square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
inline const std::string square_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
inline const std::string square_stl =
    "solid left\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
    "0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "left\n";

/// The square as STL in bytes: a header of 80, the number of facets, and fifty bytes for each.
inline std::string binary_square_stl() {
  std::string bytes(80, ' ');
  const auto add = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  add(std::uint32_t{2});
  for (const auto& facet : {std::array<float, 12>{0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0},
                            std::array<float, 12>{0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0}}) {
    for (const float number : facet) add(number);
    add(std::uint16_t{0});
  }
  return bytes;
}

/// Rows × columns vertices, `step` apart, as quads in an OBJ file: as a sheet has its cells.
inline std::string grid_obj(int rows, int columns, double step) {
  std::string text;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      text += fmt::format("v {} {} 0\n", step * column, -step * row);
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const int corner = row * columns + column + 1;
      text += fmt::format("f {} {} {} {}\n", corner, corner + columns, corner + columns + 1, corner + 1);
    }
  return text;
}

/// What reading a file gives; the message of what is wrong with it.
template <class Spec, auto read_file_of>
class FilesOf {
 public:
  auto read(const std::string& name, const std::string& text, Spec spec = {}) const {
    spec.file = name;
    return read_file_of(folder_.write(name, text), spec);
  }
  std::string error(const std::string& name, const std::string& text, const Spec& spec = {}) const {
    try {
      read(name, text, spec);
      return {};
    } catch (const BadRequest& problem) {
      return problem.what();
    }
  }

 private:
  TemporaryFolder folder_;
};
using MeshFiles = FilesOf<MeshSpec, read_mesh>;
using SolidFiles = FilesOf<MeshSolidSpec, read_solid>;

}  // namespace taut::testing
