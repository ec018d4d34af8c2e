#include "geometry/solid_surface.h"

#include <array>
#include <cmath>

#include "geometry/view_matrices.h"

namespace taut {
namespace {

constexpr double crease_cosine = 0.766;  // of 40°

struct Corner {
  Index triangle;
  double angle;  // rad
};

// The triangles around each vertex, one after another, and where those of each begin.
struct Rounds {
  std::vector<Index> begin;
  std::vector<Corner> corners;
};

Rounds rounds_of(const SolidMesh& mesh) {
  Rounds rounds;
  rounds.begin.assign(mesh.vertices().size() + 1, 0);
  for (const auto& corners : mesh.triangles())
    for (const Index vertex : corners) ++rounds.begin[vertex + 1];
  for (std::size_t i = 1; i < rounds.begin.size(); ++i) rounds.begin[i] += rounds.begin[i - 1];
  rounds.corners.resize(rounds.begin.back());
  std::vector<Index> next = rounds.begin;
  for (Index triangle = 0; triangle < mesh.triangles().size(); ++triangle) {
    const std::array<Vec3, 3> at = mesh.corners_of(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 one = at[(k + 1) % 3] - at[k], other = at[(k + 2) % 3] - at[k];
      rounds.corners[next[mesh.triangles()[triangle][k]]++] = {
          triangle, std::atan2(one.cross(other).norm(), one.dot(other))};
    }
  }
  return rounds;
}

}  // namespace

// A vertex is there once for each normal that its triangles see.
SolidSurface solid_surface(const SolidMesh& mesh) {
  const Rounds rounds = rounds_of(mesh);
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles().size());
  for (Index i = 0; i < mesh.triangles().size(); ++i) {
    const std::array<Vec3, 3> at = mesh.corners_of(i);
    normals.emplace_back((at[1] - at[0]).cross(at[2] - at[0]).stableNormalized());
  }
  SolidSurface surface;
  surface.vertices.reserve(mesh.vertices().size());
  surface.triangles.reserve(3 * mesh.triangles().size());
  std::vector<std::vector<Index>> made(mesh.vertices().size());  // of each vertex of the mesh
  for (Index i = 0; i < mesh.triangles().size(); ++i)
    for (const Index vertex : mesh.triangles()[i]) {
      Vec3 sum = Vec3::Zero();
      for (Index k = rounds.begin[vertex]; k < rounds.begin[vertex + 1]; ++k) {
        const Corner& corner = rounds.corners[k];
        if (normals[corner.triangle].dot(normals[i]) >= crease_cosine)
          sum += corner.angle * normals[corner.triangle];
      }
      const SolidVertex wanted{to_glm(mesh.vertices()[vertex]), to_glm(sum.stableNormalized())};
      Index number = static_cast<Index>(surface.vertices.size());
      for (const Index known : made[vertex])
        if (glm::dot(surface.vertices[known].normal, wanted.normal) > 0.9999F) number = known;
      if (number == surface.vertices.size()) {
        surface.vertices.push_back(wanted);
        made[vertex].push_back(number);
      }
      surface.triangles.push_back(number);
    }
  return surface;
}

}  // namespace taut
