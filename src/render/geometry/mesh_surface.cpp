#include "geometry/mesh_surface.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <span>

#include "base/vectors.h"
#include "geometry/view_matrices.h"

namespace taut {
namespace {

constexpr float rounding = 0.75F;  // of the way to the planes through the corners, as the paper has it

struct Corner {
  glm::vec3 place, normal;
};
using Corners = std::array<Corner, 3>;

glm::vec3 unit(const glm::vec3& vector) {
  const float length = glm::length(vector);
  return length > 0.0F ? vector / length : glm::vec3(0, 1, 0);
}

// A place of a triangle, moved towards where the planes through its corners would have it (eq. 2 there).
SurfaceVertex rounded(const Corners& corners, const glm::vec3& share, float how_far) {
  const glm::vec3 flat = share.x * corners[0].place + share.y * corners[1].place + share.z * corners[2].place;
  glm::vec3 on_planes(0.0F), normal(0.0F);
  for (int k = 0; k < 3; ++k) {
    const auto& [place, up] = corners[static_cast<std::size_t>(k)];
    on_planes += share[k] * (flat - glm::dot(flat - place, up) * up);
    normal += share[k] * up;
  }
  return {glm::mix(flat, on_planes, how_far), unit(normal), glm::vec2(1.0F)};
}

Vec3 to_eigen(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

// How a mass has turned since the start, from the ways to those beside it: as near to all of them as can be
// (Kabsch, 1976); along one line only, by the shortest turn.
glm::mat3 turn_of_mass(const TornMass& mass, const std::vector<glm::vec3>& masses,
                       const std::vector<glm::vec3>& at_start, const glm::mat3& otherwise) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Vec3 before = Vec3::Zero(), now = Vec3::Zero();
  for (const Index other : mass.beside) {
    before = to_eigen(glm::normalize(at_start[other] - at_start[mass.mass]));
    now = to_eigen(glm::normalize(masses[other] - masses[mass.mass]));
    sum += now * before.transpose();
  }
  if (mass.beside.empty() || !sum.allFinite()) return otherwise;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d turn;
  if (svd.singularValues()[1] < 1e-3 * svd.singularValues()[0]) {
    turn = Eigen::Quaterniond::FromTwoVectors(before, now).toRotationMatrix();
  } else {
    Eigen::Matrix3d flip = Eigen::Matrix3d::Identity();
    flip(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    turn = svd.matrixU() * flip * svd.matrixV().transpose();
  }
  glm::mat3 made;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) made[column][row] = static_cast<float>(turn(row, column));
  return made;
}

class MeshShaper {
 public:
  MeshShaper(const MeshCloth& cloth, const MeshTopology& topology, const std::vector<glm::vec3>& masses,
             const std::vector<glm::vec3>& at_start, const glm::mat3& to_picture,
             std::vector<glm::vec3>& normals)
      : cloth_(cloth), topology_(topology), masses_(masses), at_start_(at_start), normals_(normals) {
    for (const TornMass& mass : topology.torn_masses)
      turns_.push_back(turn_of_mass(mass, masses, at_start, to_picture));
  }

  std::vector<SurfaceVertex> make() {
    find_normals();
    std::vector<SurfaceVertex> vertices;
    vertices.reserve(topology_.whole.size() * cloth_.vertices_a_triangle() + topology_.torn_vertices.size());
    for (const Index triangle : topology_.whole) add_whole(triangle, vertices);
    for (const TornVertex& vertex : topology_.torn_vertices) vertices.push_back(torn(vertex));
    return vertices;
  }

 private:
  float how_round() const { return cloth_.parts > 1 ? rounding : 0.0F; }

  const glm::mat3& turn(Index mass) const {
    const auto found = std::ranges::lower_bound(topology_.torn_masses, mass, {}, &TornMass::mass);
    return turns_[static_cast<std::size_t>(found - topology_.torn_masses.begin())];
  }

  // Where a torn triangle's corners are as one of them sees it: beyond broken edges as they would be, had
  // they turned with it.
  std::array<glm::vec3, 3> as_seen(const TornTriangle& torn, Index corner) const {
    const auto& own = cloth_.triangles[torn.triangle].masses;
    std::array<glm::vec3, 3> places;
    for (Index k = 0; k < 3; ++k) {
      const Index edge = k == (corner + 1) % 3 ? corner : k;  // between the two
      places[k] = masses_[own[k]];
      if (k != corner && torn.broken[edge])
        places[k] = masses_[own[corner]] + turn(own[corner]) * (at_start_[own[k]] - at_start_[own[corner]]);
    }
    return places;
  }

  // Means over the triangles around each mass, as their area is.
  void find_normals() {
    const auto add = [this](Index mass, const std::array<glm::vec3, 3>& at) {
      normals_[mass] += glm::cross(at[1] - at[0], at[2] - at[0]);
    };
    for (const MeshTriangle& triangle : cloth_.triangles)
      for (const Index mass : triangle.masses) normals_[mass] = glm::vec3(0.0F);
    for (const Index whole : topology_.whole) {
      const auto& own = cloth_.triangles[whole].masses;
      for (const Index mass : own) add(mass, {masses_[own[0]], masses_[own[1]], masses_[own[2]]});
    }
    for (const TornTriangle& torn : topology_.torn)
      for (Index corner = 0; corner < 3; ++corner)
        add(cloth_.triangles[torn.triangle].masses[corner], as_seen(torn, corner));
    for (const MeshTriangle& triangle : cloth_.triangles)
      for (const Index mass : triangle.masses) normals_[mass] = unit(normals_[mass]);
  }

  void add_whole(Index triangle, std::vector<SurfaceVertex>& vertices) const {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index mass = cloth_.triangles[triangle].masses[k];
      corners[k] = {masses_[mass], normals_[mass]};
    }
    const Index parts = cloth_.parts;
    for (Index down = 0; down <= parts; ++down)
      for (Index across = 0; across + down <= parts; ++across) {
        const glm::vec2 towards = glm::vec2(across, down) / static_cast<float>(parts);
        vertices.push_back(
            rounded(corners, glm::vec3(1.0F - towards.x - towards.y, towards.x, towards.y), how_round()));
      }
  }

  SurfaceVertex of_corner(const TornTriangle& torn, Index corner, const glm::vec3& share) const {
    const std::array<glm::vec3, 3> places = as_seen(torn, corner);
    const auto& own = cloth_.triangles[torn.triangle].masses;
    Corners corners;
    for (Index k = 0; k < 3; ++k) {
      const bool there = places[k] == masses_[own[k]];
      corners[k] = {places[k], normals_[there ? own[k] : own[corner]]};
    }
    return rounded(corners, share, how_round());
  }

  SurfaceVertex torn(const TornVertex& vertex) const {
    const TornTriangle& of = topology_.torn[vertex.torn];
    if (!vertex.middle) return of_corner(of, vertex.corner, vertex.share);
    SurfaceVertex mean{glm::vec3(0.0F), glm::vec3(0.0F), glm::vec2(1.0F)};
    float count = 0.0F;
    for (const Index corner : joined(of, vertex.corner)) {
      const SurfaceVertex seen = of_corner(of, corner, vertex.share);
      mean.position += seen.position;
      mean.normal += seen.normal;
      count += 1.0F;
    }
    return {mean.position / count, unit(mean.normal), glm::vec2(1.0F)};
  }

  // The corners that whole edges lead to, itself among them.
  static std::vector<Index> joined(const TornTriangle& torn, Index corner) {
    const auto whole = [&](Index a, Index b) { return !torn.broken[b == (a + 1) % 3 ? a : b]; };
    const Index next = (corner + 1) % 3, before = (corner + 2) % 3;
    const bool others = whole(next, before);
    const bool to_next = whole(corner, next) || (whole(corner, before) && others);
    const bool to_before = whole(corner, before) || (whole(corner, next) && others);
    std::vector<Index> corners{corner};
    if (to_next) corners.push_back(next);
    if (to_before) corners.push_back(before);
    std::ranges::sort(corners);  // all of them add up alike
    return corners;
  }

  const MeshCloth& cloth_;
  const MeshTopology& topology_;
  const std::vector<glm::vec3>& masses_;
  const std::vector<glm::vec3>& at_start_;
  std::vector<glm::vec3>& normals_;
  std::vector<glm::mat3> turns_;
};

}  // namespace

std::vector<SurfaceVertex> mesh_vertices(const MeshCloth& cloth, const MeshTopology& topology,
                                         const std::vector<glm::vec3>& masses,
                                         const std::vector<glm::vec3>& at_start, const glm::mat3& to_picture,
                                         std::vector<glm::vec3>& normals) {
  return MeshShaper(cloth, topology, masses, at_start, to_picture, normals).make();
}

}  // namespace taut
