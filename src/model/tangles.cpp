#include "model/tangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/box_tree.h"
#include "model/face_pairs.h"

namespace taut {
namespace {

// The sign of the volume that a, b, c and d span, 0 where rounding may hide it.
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  constexpr double unit = 0x1p-53, bound = (7.0 + 56.0 * unit) * unit;
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double vw = v.x() * w.y(), wv = w.x() * v.y();
  const double wu = w.x() * u.y(), uw = u.x() * w.y();
  const double uv = u.x() * v.y(), vu = v.x() * u.y();
  const double volume = u.z() * (vw - wv) + v.z() * (wu - uw) + w.z() * (uv - vu);
  const double sizes = (std::abs(vw) + std::abs(wv)) * std::abs(u.z()) +
                       (std::abs(wu) + std::abs(uw)) * std::abs(v.z()) +
                       (std::abs(uv) + std::abs(vu)) * std::abs(w.z());
  if (volume > bound * sizes) return 1;
  return -volume > bound * sizes ? -1 : 0;
}

// Whether an edge and a triangle are too near each other for the signs to be certain. If they are not, no
// volume of an edge that goes through is near 0: the place where it does is inside the triangle, and both
// ends are off its plane.
bool nearly_touch(const std::array<Vec3, 2>& edge, const std::array<Vec3, 3>& triangle) {
  constexpr double share = 1e-10;  // of the coordinates
  double size = 0.0, nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& end : edge) {
    size = std::max(size, end.cwiseAbs().maxCoeff());
    nearest = std::min(nearest, nearest_gap(false, {end, triangle[0], triangle[1], triangle[2]}).distance);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    size = std::max(size, triangle[k].cwiseAbs().maxCoeff());
    nearest =
        std::min(nearest, nearest_gap(true, {edge[0], edge[1], triangle[k], triangle[(k + 1) % 3]}).distance);
  }
  return !(nearest > share * size);
}

template <std::size_t count>
std::array<Vec3, count> places_of(const std::array<std::uint32_t, count>& nodes,
                                  const std::vector<Vec3>& places) {
  std::array<Vec3, count> there;
  for (std::size_t k = 0; k < count; ++k) there[k] = places[nodes[k]];
  return there;
}

template <std::size_t count>
Bounds box_of(const std::array<std::uint32_t, count>& nodes, const std::vector<Vec3>& places) {
  Bounds box;
  for (const std::uint32_t node : nodes) box.take_in(places[node], 0.0);
  return box;
}

}  // namespace

Piercing piercing(const std::array<Vec3, 2>& edge, const std::array<Vec3, 3>& triangle) {
  const auto& [p, q] = edge;
  const auto& [a, b, c] = triangle;
  const int of_p = side(a, b, c, p), of_q = side(a, b, c, q);
  if (of_p * of_q > 0) return Piercing::none;
  const std::array around{side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)};
  const bool some_left = std::ranges::count(around, 1) > 0, some_right = std::ranges::count(around, -1) > 0;
  if (some_left && some_right) return Piercing::none;
  const bool certain = of_p * of_q < 0 && std::ranges::count(around, 0) == 0;
  if (certain) return Piercing::through;
  return nearly_touch(edge, triangle) ? Piercing::unclear : Piercing::none;
}

std::vector<Tangle> find_tangles(const FaceMesh& mesh, const WholeFaces& whole,
                                 const std::vector<Vec3>& places, std::size_t most) {
  std::vector<Bounds> boxes;
  for (const std::uint32_t edge : whole.edges) boxes.push_back(box_of(mesh.edges[edge].nodes, places));
  BoxTree edges, triangles;
  edges.fill(boxes);
  boxes.clear();
  for (const std::uint32_t triangle : whole.triangles)
    boxes.push_back(box_of(mesh.triangles[triangle], places));
  triangles.fill(boxes);
  std::vector<Tangle> tangles;
  edges.visit_pairs(triangles, [&](std::uint32_t i, std::uint32_t j) {
    const Tangle tangle{mesh.edges[whole.edges[i]].nodes, mesh.triangles[whole.triangles[j]]};
    const bool joined = std::ranges::find_first_of(tangle.edge, tangle.triangle) != tangle.edge.end();
    if (joined || tangles.size() > most ||
        !mesh.meet(mesh.group[tangle.edge[0]], mesh.group[tangle.triangle[0]]))
      return;
    if (piercing(places_of(tangle.edge, places), places_of(tangle.triangle, places)) != Piercing::none)
      tangles.push_back(tangle);
  });
  return tangles;
}

std::size_t tangled_places(const Model& model, const State& state) {
  if (model.faces.empty()) return 0;
  const FaceMesh mesh(model);
  std::vector<Vec3> places;
  mesh.places(state.position, state.time, places);
  return find_tangles(mesh, whole_faces(mesh, model, state.broken_at), places,
                      std::numeric_limits<std::size_t>::max())
      .size();
}

}  // namespace taut
