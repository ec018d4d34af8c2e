#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "geometry/surface_records.h"
#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// A triangle of a mesh that is drawn as cloth, and what its corners keep.
struct MeshTriangle {
  std::array<Index, 3> masses;
  std::array<Index, 3> links;        ///< from each corner to the next; no_link along a quad's diagonal
  Index other_half = 0;              ///< the other triangle of its quad; itself where it is of none
  std::array<glm::vec2, 3> pattern;  ///< as SurfacePlace::pattern
  std::array<glm::vec2, 3> borders;  ///< as SurfacePlace::edges.xy: from up to two borders
  Index mesh = 0;                    ///< in MeshCloth::tints
};

/// What never changes about the meshes of a model that are drawn as cloth.
struct MeshCloth {
  std::vector<MeshTriangle> triangles;
  Index parts = 1;                 ///< that each side of a triangle is drawn in: 1, 2 or 4
  std::vector<SurfaceTint> tints;  ///< of each mesh; empty where all cloth has the look's colours
  float part_length = 0.0F;        ///< m, of a part of a side, in the mean
  std::vector<glm::vec3> normals;  ///< unit vectors, of each mass at the start, in the world's axes

  bool empty() const { return triangles.empty(); }
  /// Vertices of a triangle that is whole: along the side from its first corner to its second, and so on up
  /// to the third.
  Index vertices_a_triangle() const { return (parts + 1) * (parts + 2) / 2; }
};

/// `drawn`: which of the model's sheets are drawn as cloth.
MeshCloth mesh_cloth(const Model& model, const State& start, const Look& look, const std::vector<bool>& drawn,
                     float pixels_a_metre);

/// Squares of places in the map of light, one a triangle: its first corner at their top left, its second to
/// the right, its third below, with a margin all around, since pixels look a little beyond the edges of what
/// they show. Half of a square is of no use, but triangles that share none keep their light apart however
/// they are joined.
struct MeshBlocks {
  Index count = 0, side = 0, a_row = 0;  ///< how many; places along a side; blocks beside each other
  Index first_row = 0;                   ///< of places, where they begin

  /// Of the first corner.
  glm::uvec2 first_place(Index block) const {
    return {block % a_row * side + 1, first_row + block / a_row * side + 1};
  }
};

}  // namespace taut
