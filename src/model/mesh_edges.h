#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "model/mesh_data.h"
#include "model/mesh_triangles.h"

namespace taut {

/// The edges of a mesh, in the order in which its faces come to them, and what lies beside them.
class MeshEdges {
 public:
  struct Edge {
    std::array<Index, 2> ends;   ///< vertices, as the first face has them
    std::array<Index, 2> faces;  ///< the same twice at a border
    bool at_border() const { return faces[0] == faces[1]; }
  };

  explicit MeshEdges(const MeshData& mesh);

  const std::vector<Edge>& all() const { return edges_; }
  /// The number of the edge between two vertices; no_link where there is none.
  Index between(Index a, Index b) const;

 private:
  static std::uint64_t key(Index a, Index b) {
    return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
  }

  std::vector<Edge> edges_;
  std::unordered_map<std::uint64_t, Index> number_;
};

/// Two edges that go on as straight as any over a vertex.
struct StraightPair {
  Index before = 0, middle = 0, after = 0;  ///< vertices
  bool among_quads = false;                 ///< whether all faces about the middle have four corners
};

/// Of the edges at each vertex those that go on from each other, each at most once: the straightest first,
/// and none that turn by more than 45°. On a grid those are the warp and the weft.
std::vector<StraightPair> straight_pairs(const MeshData& mesh, const MeshEdges& edges);

}  // namespace taut
