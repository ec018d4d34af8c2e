#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <charconv>
#include <numeric>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "raw_mesh.h"

namespace taut {
namespace {

// Where the vertices and faces of a PLY file that is text stand in it, an element a line behind the header.
void find_lines(std::string_view text, RawMesh& mesh) {
  if (!text.starts_with("ply") || text.find("format ascii") > text.find("end_header")) return;
  struct Element {
    std::string_view name;
    std::size_t count = 0;
  };
  std::vector<Element> elements;
  std::size_t line = 0;
  for (bool in_header = true; in_header && !text.empty();) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view words = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line;
    in_header = !words.starts_with("end_header");
    if (!words.starts_with("element ")) continue;
    words.remove_prefix(8);
    const std::size_t blank = std::min(words.find(' '), words.size());
    Element& element = elements.emplace_back(Element{words.substr(0, blank)});
    words.remove_prefix(std::min(blank + 1, words.size()));
    std::from_chars(words.data(), words.data() + words.size(), element.count);
  }
  for (const Element& element : elements) {
    const bool vertices = element.name == "vertex", faces = element.name == "face";
    const std::size_t there = vertices ? mesh.vertices.size() : mesh.face_count();
    if (there == element.count && (vertices || faces)) {
      std::vector<std::size_t>& lines = vertices ? mesh.vertex_line : mesh.face_line;
      lines.resize(there);
      std::iota(lines.begin(), lines.end(), line + 1);
    }
    line += element.count;
  }
}

void add_part(const aiMesh& part, const std::string& called, RawMesh& mesh) {
  const auto first = static_cast<Index>(mesh.vertices.size());
  const std::string_view name(part.mName.C_Str(), part.mName.length);
  mesh.vertices.reserve(mesh.vertices.size() + part.mNumVertices);
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& at = part.mVertices[i];
    mesh.vertices.emplace_back(at.x, at.y, at.z);
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices < 3) continue;  // a line or a point
    if (!name.empty())
      mesh.face_groups.push_back(
          {static_cast<Index>(mesh.face_count()), static_cast<Index>(mesh.groups.size())});
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] >= part.mNumVertices)
        throw BadRequest(fmt::format("{}: face {} has vertex {}, counted from 0, and there are {}", called,
                                     mesh.face_count(), face.mIndices[k], part.mNumVertices));
      mesh.corners.push_back(first + face.mIndices[k]);
    }
    mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
  }
  if (!name.empty()) mesh.groups.emplace_back(name);
}

}  // namespace

RawMesh parse_ply(const std::string& bytes, const std::string& called) {
  if (!bytes.starts_with("ply"))
    throw BadRequest(fmt::format("{}: not a PLY file, which begins with \"ply\"", called));
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "ply");
  if (scene == nullptr) {
    std::string reason = importer.GetErrorString();
    std::ranges::replace(reason, '\n', ' ');
    throw BadRequest(fmt::format("{}: not a whole PLY file: {}", called, in_quotes(reason)));
  }
  RawMesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) add_part(*scene->mMeshes[i], called, mesh);
  find_lines(bytes, mesh);
  return mesh;
}

}  // namespace taut
