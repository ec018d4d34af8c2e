#include "meshes/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "base/hash.h"
#include "base/memory.h"
#include "file_bytes.h"
#include "placed_mesh.h"
#include "raw_mesh.h"
#include "solid_of_mesh.h"

namespace taut {
namespace {

// A file name's ending in small letters, without its dot.
std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending.empty() ? ending : ending.substr(1);
}

// A mesh as it stands in a file, and the hash of that.
RawMesh raw_mesh(const std::filesystem::path& file, const MeshSpec& spec, std::string& content) {
  const std::string kind = ending_of(file);
  if (kind != "obj" && kind != "ply" && kind != "stl")
    throw BadRequest(fmt::format("{}: a mesh's file ends in .obj, .ply or .stl, and not in {}", spec.file,
                                 kind.empty() ? "nothing" : in_quotes("." + kind)));
  const std::string bytes = file_bytes(file, spec.file);
  content = Hash().add(bytes).hex();
  return kind == "obj"   ? parse_obj(bytes, spec.file)
         : kind == "ply" ? parse_ply(bytes, spec.file)
                         : parse_stl(bytes, spec.file);
}

// Where a solid's mesh goes, as that of cloth is told.
MeshSpec placing_of(const MeshSolidSpec& solid) {
  MeshSpec mesh;
  mesh.file = solid.file;
  mesh.scale = solid.scale;
  mesh.up = solid.up;
  mesh.position = solid.position;
  mesh.turn = solid.turn;
  mesh.weld = solid.weld;
  return mesh;
}

void require_memory(const RawMesh& raw, const std::string& file) {
  constexpr double bytes_a_triangle = 1200.0;  // while it is made, faces that touch it among that
  const double needed = bytes_a_triangle * (static_cast<double>(raw.corners.size()) -
                                            2.0 * static_cast<double>(raw.face_count()));
  if (needed > 0.8 * usable_memory())
    throw BadRequest(fmt::format("{}: its {} faces need about {} as a solid; this machine has {}", file,
                                 raw.face_count(), format_bytes(needed), format_bytes(usable_memory())));
}

}  // namespace

MeshReading read_mesh(const std::filesystem::path& file, const MeshSpec& spec) {
  MeshReading reading;
  const RawMesh raw = raw_mesh(file, spec, reading.content);
  PlacedMesh placed = placed_mesh(raw, spec, MeshUse::cloth, reading.notes);
  reading.data = std::make_shared<const MeshData>(std::move(placed.data));
  return reading;
}

SolidReading read_solid(const std::filesystem::path& file, const MeshSolidSpec& spec) {
  SolidReading reading;
  const MeshSpec placing = placing_of(spec);
  const RawMesh raw = raw_mesh(file, placing, reading.content);
  require_memory(raw, spec.file);
  const PlacedMesh placed = placed_mesh(raw, placing, MeshUse::solid, reading.notes);
  reading.data = std::make_shared<const SolidData>(solid_of_mesh(raw, placed, spec.file, reading.notes));
  return reading;
}

}  // namespace taut
