#include "geometry/run_frame.h"

#include <Eigen/Geometry>

namespace taut {
namespace {

// Across a direction, as x is across what hangs down: jumps only where the direction passes straight up.
Vec3 first_normal(const Vec3& direction) {
  return Eigen::Quaterniond::FromTwoVectors(-Vec3::UnitY(), direction) * Vec3::UnitX();
}

}  // namespace

std::vector<Vec3> carried_normals(const std::vector<Vec3>& directions) {
  std::vector<Vec3> normals;
  for (const Vec3& direction : directions) {
    const Vec3 before = normals.empty() ? first_normal(direction) : normals.back();
    const Vec3 across = before - direction * direction.dot(before);
    normals.push_back(across.norm() > 1e-6 ? Vec3(across.normalized()) : first_normal(direction));
  }
  return normals;
}

}  // namespace taut
