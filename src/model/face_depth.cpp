#include "model/face_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/face_pairs.h"
#include "model/mesh_depth.h"
#include "model/solid_mesh.h"

namespace taut {
namespace {

// The least value of a convex function of one number from 0 to 1: golden sections, down to 1e-9.
template <class Function>
double least_of(const Function& f) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.0, high = 1.0;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = f(a), at_b = f(b), least = std::min(f(low), f(high));
  for (int cut = 0; cut < 44; ++cut) {
    least = std::min({least, at_a, at_b});
    if (at_a < at_b) {
      high = b;
      b = a;
      at_b = at_a;
      at_a = f(a = high - golden * (high - low));
    } else {
      low = a;
      a = b;
      at_a = at_b;
      at_b = f(b = low + golden * (high - low));
    }
  }
  return least;
}

std::array<Vec3, 3> corners_of(const Triangle& triangle, const Vectors& position) {
  return {position.at(triangle.masses[0]), position.at(triangle.masses[1]), position.at(triangle.masses[2])};
}

bool is_whole(const Triangle& triangle, const State& state) {
  return std::ranges::none_of(triangle.links,
                              [&](Index link) { return link != no_link && state.broken(link); });
}

double depth_in_solids(const Model& model, const State& state, const SheetFaces& faces) {
  const Sheet& sheet = model.sheets[faces.sheet];
  const double half = 0.5 * faces.thickness;
  double deepest = 0.0;
  std::vector<Shape> shapes;
  for (const Collider& collider : model.colliders) shapes.push_back(shape_at(collider, state.time));
  for (Index i = sheet.first_triangle; i < sheet.first_triangle + sheet.triangle_count; ++i) {
    const Triangle& triangle = model.triangles[i];
    if (!is_whole(triangle, state)) continue;
    const std::array<Vec3, 3> corners = corners_of(triangle, state.position);
    for (const Shape& shape : shapes)
      if (may_be_within(half - deepest, shape, corners))
        deepest = std::max(deepest, half - least_distance(shape, corners));
  }
  return deepest;
}

double overlap_of_faces(const Model& model, const State& state) {
  const FaceMesh mesh(model);
  if (!mesh.any_meet()) return 0.0;
  std::vector<Vec3> places;
  mesh.places(state.position, state.time, places);
  std::vector<FacePair> pairs;
  find_face_pairs(mesh, whole_faces(mesh, model, state.broken_at), places,
                  std::vector<double>(mesh.size(), 0.0), std::numeric_limits<std::size_t>::max(), pairs);
  double deepest = 0.0;
  for (const FacePair& pair : pairs)
    if (!mesh.of_solid(pair.nodes[0]) && !mesh.of_solid(pair.nodes[3]))
      deepest = std::max(deepest, kept_apart(mesh, pair) - nearest_gap(pair, places).distance);
  return deepest;
}

}  // namespace

// No place of a triangle is farther from its middle than a corner.
bool may_be_within(double reach, const Shape& shape, const std::array<Vec3, 3>& corners) {
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  double radius = 0.0;
  for (const Vec3& corner : corners) radius = std::max(radius, (corner - middle).norm());
  return surface_within(shape, middle, reach + radius).has_value();
}

// The distance from a convex solid, negative inside, is a convex function of the place. Where at the middle
// of the triangle it is the mean of those at the corners, it is linear on all of it; else its least value is
// looked for on lines from one side to the corner across, each of which has one.
double least_distance(const Shape& shape, const std::array<Vec3, 3>& corners) {
  if (const auto* solid = std::get_if<MeshSolid>(&shape))
    return least_distance(*solid->mesh,
                          {solid->back(corners[0]), solid->back(corners[1]), solid->back(corners[2])});
  const auto distance = [&](const Vec3& place) { return nearest_surface(shape, place).distance; };
  const std::array at{distance(corners[0]), distance(corners[1]), distance(corners[2])};
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const double mean = (at[0] + at[1] + at[2]) / 3.0;
  const double rounding = 1e-12 * (std::abs(at[0]) + std::abs(at[1]) + std::abs(at[2]) + middle.norm());
  if (distance(middle) > mean - rounding) return *std::ranges::min_element(at);
  return least_of([&](double u) {
    const Vec3 on_side = corners[0] + u * (corners[1] - corners[0]);
    return least_of([&](double v) { return distance(on_side + v * (corners[2] - on_side)); });
  });
}

double deepest_face(const Model& model, const State& state) {
  if (model.faces.empty()) return 0.0;
  double deepest = overlap_of_faces(model, state);
  for (const SheetFaces& faces : model.faces)
    deepest = std::max(deepest, depth_in_solids(model, state, faces));
  return deepest;
}

}  // namespace taut
