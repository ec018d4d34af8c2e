#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/face_mesh.h"

namespace taut {

/// A point and a triangle (nodes: the point, the triangle's three), or two edges (two nodes of each).
struct FacePair {
  std::array<std::uint32_t, 4> nodes{};
  bool edges = false;
  double distance = 0.0;  ///< m, where it was found

  std::size_t first_of_other() const { return edges ? 2 : 1; }
};

/// Where the two of a pair are nearest to each other: apart = Σ weightₖ xₖ leads from the second to the
/// first, with weights that sum to 1 over the first and to −1 over the second.
struct FaceGap {
  std::array<double, 4> weights{};
  Vec3 apart = Vec3::Zero();  ///< m
  double distance = 0.0;      ///< m, |apart|
};
FaceGap nearest_gap(bool edges, const std::array<Vec3, 4>& corners);
FaceGap nearest_gap(const FacePair& pair, const std::vector<Vec3>& places);

/// How far apart (m) the middles of a pair's two are kept: their radii.
inline double kept_apart(const FaceMesh& mesh, const FacePair& pair) {
  return mesh.radius[pair.nodes[0]] + mesh.radius[pair.nodes[3]];
}
/// The part of that which nothing may ever enter (m): radii of solids.
inline double kept_clear(const FaceMesh& mesh, const FacePair& pair) {
  return mesh.core[pair.nodes[0]] + mesh.core[pair.nodes[3]];
}

/// Of a thickness, that links may push a pair nearer within a step than it was going to be.
inline constexpr double look_ahead = 0.25;
/// How near (m) they have to come to be watched.
inline double watched_apart(const FaceMesh& mesh, const FacePair& pair) {
  return kept_apart(mesh, pair) + look_ahead * (kept_apart(mesh, pair) - kept_clear(mesh, pair));
}

/// Finds the pairs that can come into contact while no node leaves a ball around its place: those whose
/// distance can come to watched_apart(), each once, points with triangles before edges and both rising; all
/// of them, unless there are more than about `most`. `rooms`: the radius (m) of each node's ball.
void find_face_pairs(const FaceMesh& mesh, const WholeFaces& whole, const std::vector<Vec3>& places,
                     const std::vector<double>& rooms, std::size_t most, std::vector<FacePair>& pairs);

}  // namespace taut
