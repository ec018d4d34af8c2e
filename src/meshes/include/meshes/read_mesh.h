#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/description.h"

namespace taut {

/// What a mesh's file holds, placed as its entry says.
struct MeshReading {
  std::shared_ptr<const MeshData> data;
  std::string content;  ///< hash of the file's bytes
  std::vector<std::string>
      notes;  ///< what was done to it that may surprise, a sentence each without full stop
};

/// Reads a mesh of the formats OBJ (Wavefront, Object Files, appendix B1 of the Advanced Visualizer manual),
/// PLY (Turk, 1994) or STL (3D Systems, 1989), by the ending of its file's name, and places it by `scale`,
/// `up`, `turn` and `position`. Corners nearer than `weld` are one; faces with more than four corners are cut
/// into triangles; faces are turned to run around as their neighbours do. Throws BadRequest, one sentence
/// that begins with the file as the entry names it and where it can be had the line, for what can be no
/// cloth.
MeshReading read_mesh(const std::filesystem::path& file, const MeshSpec& spec);

/// What a solid's mesh file holds, placed as its entry says.
struct SolidReading {
  std::shared_ptr<const SolidData> data;
  std::string content;             ///< hash of the file's bytes
  std::vector<std::string> notes;  ///< as of a mesh
};

/// Reads the surface of a solid, of the same formats and in the same way. Its faces are turned to look
/// outwards, those of a piece within another one into the hollow. Throws BadRequest, as above, for a surface
/// that is open, has one side only, goes through itself, touches itself at a corner or has no volume, and for
/// more faces than there is memory for.
SolidReading read_solid(const std::filesystem::path& file, const MeshSolidSpec& spec);

}  // namespace taut
