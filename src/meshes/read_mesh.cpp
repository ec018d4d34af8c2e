#include "meshes/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "base/hash.h"
#include "cloth_of_mesh.h"
#include "file_bytes.h"
#include "raw_mesh.h"

namespace taut {
namespace {

// A file name's ending in small letters, without its dot.
std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending.empty() ? ending : ending.substr(1);
}

}  // namespace

MeshReading read_mesh(const std::filesystem::path& file, const MeshSpec& spec) {
  const std::string kind = ending_of(file);
  if (kind != "obj" && kind != "ply" && kind != "stl")
    throw BadRequest(fmt::format("{}: a mesh's file ends in .obj, .ply or .stl, and not in {}", spec.file,
                                 kind.empty() ? "nothing" : in_quotes("." + kind)));
  const std::string bytes = file_bytes(file, spec.file);
  MeshReading reading;
  reading.content = Hash().add(bytes).hex();
  const RawMesh raw = kind == "obj"   ? parse_obj(bytes, spec.file)
                      : kind == "ply" ? parse_ply(bytes, spec.file)
                                      : parse_stl(bytes, spec.file);
  reading.data = std::make_shared<const MeshData>(cloth_of_mesh(raw, spec, reading.notes));
  return reading;
}

}  // namespace taut
