#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/nearest.h"
#include "builder.h"
#include "checker.h"
#include "mesh_edges.h"

namespace taut {
namespace {

// The least height of a triangle of a mesh, and which.
double least_height(const MeshData& mesh) {
  double least = infinity;
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    for (const auto& [a, b, c] : triangles_of(mesh, face)) {
      const Vec3 ab = mesh.vertices[b] - mesh.vertices[a], ac = mesh.vertices[c] - mesh.vertices[a];
      const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
      least = std::min(least, ab.cross(ac).norm() / longest);
    }
  return least;
}

void check_mesh_faces(Checker& check, const MeshSpec& mesh) {
  check.positive(mesh.faces->thickness, "faces", "m thick");
  check.not_negative(mesh.faces->friction, "faces", "");
  check.require(mesh.radius == 0.0, "radius",
                "a mesh whose faces touch has a thickness in place of a radius: write one of the two");
  const double most = 0.5 * least_height(*mesh.data);
  check.require(
      !(mesh.faces->thickness > most), "faces",
      fmt::format("faces must be at most half as thick as the least height of one, {:.4g} m, not {:.4g} m: "
                  "else neighbours are in each other's way",
                  most, mesh.faces->thickness));
}

void check_pins(Checker& check, const MeshSpec& mesh) {
  const MeshData& data = *mesh.data;
  const std::vector<std::string_view> groups(data.groups.begin(), data.groups.end());
  for (const std::string& name : mesh.pinned) {
    if (std::ranges::find(groups, name) != groups.end()) continue;
    check.require_named(false, "pinned",
                        groups.empty()
                            ? fmt::format("\"{}\" has no groups, and so no \"{}\"", mesh.file, name)
                            : fmt::format("\"{}\" has no group or material named \"{}\"", mesh.file, name),
                        nearest_name(name, groups));
  }
  const auto count = static_cast<double>(data.vertices.size());
  bool known = true;
  for (const int number : mesh.pinned_masses) {
    const bool there = number >= 0 && number < count;
    check.require(there, "pinned_masses",
                  fmt::format("\"{}\" has masses 0 to {}, and no {}", mesh.name, count - 1, number));
    known = known && there;
  }
  if (!known) return;
  const std::vector<bool> pins = pinned_vertices(mesh);
  const bool any = std::ranges::find(pins, true) != pins.end();
  if (mesh.pinned_box && mesh.pinned.empty() && mesh.pinned_masses.empty())
    check.require(any, "pinned_box", "no mass of the mesh starts in this box");
  check.motion(mesh.motion, any, "motion");
  check.release(mesh.release, any, "release");
}

void check_mesh(Checker& check, const MeshSpec& mesh) {
  check.name(mesh.name);
  check.positive(mesh.mass, "mass", "kg");
  check.not_negative(mesh.radius, "radius", "m");
  if (mesh.bending) check.not_negative(mesh.bending->stiffness, "bending", "N m/rad");
  check.properties(mesh.properties);
  if (mesh.diagonals) check.properties(*mesh.diagonals, "diagonals.");
  if (mesh.skip_one) check.properties(*mesh.skip_one, "skip_one.");
  check.require(mesh.data != nullptr, "file", "the mesh has not been read");
  if (!mesh.data) return;
  check_pins(check, mesh);
  if (mesh.faces) check_mesh_faces(check, mesh);
}

void check_points(Checker& check, const PointsSpec& points) {
  check.name(points.name);
  check.positive(points.mass, "mass", "kg");
  check.not_negative(points.radius, "radius", "m");
  check.properties(points.properties);
  check.require(points.data != nullptr, "masses", "the tables have not been read");
  if (!points.data) return;
  std::vector<std::string_view> names;
  names.reserve(points.data->masses.size());
  for (const PointsData::Mass& mass : points.data->masses) names.emplace_back(mass.name);
  for (const std::string& pin : points.pinned)
    if (std::ranges::find(names, pin) == names.end())
      check.require_named(false, "pinned", fmt::format("\"{}\" has no mass named \"{}\"", points.masses, pin),
                          nearest_name(pin, names));
}

}  // namespace

void check_files(Checker& check, const Description& description) {
  check_each(check, "mesh", description.meshes, check_mesh);
  check_each(check, "points", description.points, check_points);
}

}  // namespace taut
