#include "model/mesh_depth.h"

#include <algorithm>
#include <limits>

#include "model/face_pairs.h"
#include "model/tangles.h"

namespace taut {
namespace {

constexpr int looks_a_side = 16;

bool go_through_each_other(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (piercing({a[k], a[(k + 1) % 3]}, b) == Piercing::through ||
        piercing({b[k], b[(k + 1) % 3]}, a) == Piercing::through)
      return true;
  return false;
}

// Of two triangles that do not go through each other.
double distance_between(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min({least, nearest_gap(false, {a[k], b[0], b[1], b[2]}).distance,
                      nearest_gap(false, {b[k], a[0], a[1], a[2]}).distance});
    for (std::size_t l = 0; l < 3; ++l)
      least = std::min(least, nearest_gap(true, {a[k], a[(k + 1) % 3], b[l], b[(l + 1) % 3]}).distance);
  }
  return least;
}

double deepest_of_places(const SolidMesh& solid, const std::array<Vec3, 3>& corners) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= looks_a_side; ++i)
    for (int j = 0; i + j <= looks_a_side; ++j) {
      const double u = static_cast<double>(i) / looks_a_side, v = static_cast<double>(j) / looks_a_side;
      const Vec3 place = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
      least = std::min(least, solid.nearest(place).distance);
    }
  return least;
}

}  // namespace

double least_distance(const SolidMesh& solid, const std::array<Vec3, 3>& corners) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& corner : corners) least = std::min(least, solid.nearest(corner).distance);
  if (least < 0.0) return deepest_of_places(solid, corners);
  Bounds around;
  for (const Vec3& corner : corners) around.take_in(corner, least);
  bool through = false;
  solid.visit_near(around, [&](Index triangle) {
    const std::array<Vec3, 3> other = solid.corners_of(triangle);
    through = through || go_through_each_other(corners, other);
    least = std::min(least, distance_between(corners, other));
  });
  return through ? deepest_of_places(solid, corners) : least;
}

}  // namespace taut
