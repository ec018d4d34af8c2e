#include "read_files.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "base/failure.h"
#include "meshes/read_mesh.h"
#include "meshes/read_points.h"

namespace taut {
namespace {

template <class Spec, class Reading>
void take(Spec& spec, Reading reading, const std::string& file) {
  if (!spec.content.empty() && spec.content != reading.content)
    throw BadRequest(fmt::format("{}: it has changed: its content is {} now, and the scene is of {}", file,
                                 reading.content, spec.content));
  spec.content = std::move(reading.content);
  spec.data = std::move(reading.data);
}

}  // namespace

std::vector<Problem> read_files(Description& description, const std::filesystem::path& folder,
                                std::vector<Problem>& notes) {
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < description.meshes.size(); ++i) {
    MeshSpec& mesh = description.meshes[i];
    try {
      MeshReading reading = read_mesh(folder / mesh.file, mesh);
      for (std::string& note : reading.notes) notes.push_back({"mesh", i, "file", std::move(note), {}});
      take(mesh, std::move(reading), mesh.file);
    } catch (const BadRequest& problem) {
      problems.push_back({"mesh", i, "file", problem.what(), {}});
    }
  }
  for (std::size_t i = 0; i < description.mesh_solids.size(); ++i) {
    MeshSolidSpec& solid = description.mesh_solids[i];
    try {
      SolidReading reading = read_solid(folder / solid.file, solid);
      for (std::string& note : reading.notes) notes.push_back({"solid", i, "file", std::move(note), {}});
      take(solid, std::move(reading), solid.file);
    } catch (const BadRequest& problem) {
      problems.push_back({"solid", i, "file", problem.what(), {}});
    }
  }
  for (std::size_t i = 0; i < description.points.size(); ++i) {
    PointsSpec& points = description.points[i];
    try {
      take(points, read_points(folder / points.masses, folder / points.links, points), points.masses);
    } catch (const BadRequest& problem) {
      const bool of_links =
          !points.links.empty() && std::string_view(problem.what()).starts_with(points.links);
      problems.push_back({"points", i, of_links ? "links" : "masses", problem.what(), {}});
    }
  }
  return problems;
}

}  // namespace taut
