#include "mesh_edges.h"

#include <algorithm>
#include <cmath>

#include "model/limits.h"

namespace taut {

MeshEdges::MeshEdges(const MeshData& mesh) {
  edges_.reserve(mesh.corners.size());
  number_.reserve(mesh.corners.size());
  for (std::size_t number = 0; number < mesh.face_count(); ++number) {
    const auto corners = mesh.face(number);
    const auto face = static_cast<Index>(number);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index a = corners[k], b = corners[(k + 1) % corners.size()];
      const auto [known, is_new] = number_.try_emplace(key(a, b), static_cast<Index>(edges_.size()));
      if (is_new)
        edges_.push_back({{a, b}, {face, face}});
      else
        edges_[known->second].faces[1] = face;
    }
  }
}

Index MeshEdges::between(Index a, Index b) const {
  const auto found = number_.find(key(a, b));
  return found == number_.end() ? no_link : found->second;
}

std::vector<StraightPair> straight_pairs(const MeshData& mesh, const MeshEdges& edges) {
  const double straightest = -std::sqrt(0.5);  // the cosine between two edges that turn by 45°
  std::vector<std::vector<Index>> around(mesh.vertices.size());  // the other ends of each vertex's edges
  for (const MeshEdges::Edge& edge : edges.all()) {
    around[edge.ends[0]].push_back(edge.ends[1]);
    around[edge.ends[1]].push_back(edge.ends[0]);
  }
  std::vector<bool> among_quads(mesh.vertices.size(), true);
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (mesh.face(face).size() != 4)
      for (const Index corner : mesh.face(face)) among_quads[corner] = false;

  struct Candidate {
    double cosine;
    std::size_t one, other;
  };
  std::vector<StraightPair> pairs;
  std::vector<Candidate> candidates;
  for (Index middle = 0; middle < around.size(); ++middle) {
    const std::vector<Index>& others = around[middle];
    candidates.clear();
    const auto way = [&](std::size_t i) -> Vec3 {
      return (mesh.vertices[others[i]] - mesh.vertices[middle]).normalized();
    };
    for (std::size_t i = 0; i < others.size(); ++i)
      for (std::size_t k = i + 1; k < others.size(); ++k)
        if (const double cosine = way(i).dot(way(k)); cosine < straightest)
          candidates.push_back({cosine, i, k});
    std::ranges::stable_sort(candidates, {}, &Candidate::cosine);
    std::vector<bool> taken(others.size(), false);
    for (const Candidate& each : candidates) {
      if (taken[each.one] || taken[each.other]) continue;
      taken[each.one] = taken[each.other] = true;
      pairs.push_back({others[each.one], middle, others[each.other], among_quads[middle]});
    }
  }
  return pairs;
}

std::vector<std::array<Index, 3>> triangles_of(const MeshData& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  if (corners.size() == 3) return {{corners[0], corners[1], corners[2]}};
  const auto place = [&](std::size_t k) -> const Vec3& { return mesh.vertices[corners[k % 4]]; };
  const auto area = [&](std::size_t k) -> Vec3 {  // of the corner k and its neighbours, twice
    return (place(k + 1) - place(k)).cross(place(k + 3) - place(k));
  };
  // A diagonal lies within where the triangles on both sides of it face the same way.
  const bool first_within = area(1).dot(area(3)) > 0.0, second_within = area(0).dot(area(2)) > 0.0;
  const bool second_shorter =
      (place(3) - place(1)).squaredNorm() < (place(2) - place(0)).squaredNorm() * (1.0 - 1e-9);
  if (second_within && (second_shorter || !first_within))
    return {{corners[0], corners[1], corners[3]}, {corners[3], corners[1], corners[2]}};
  return {{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}};
}

}  // namespace taut
