#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/box_tree.h"
#include "model/inside_grid.h"
#include "model/surface.h"

namespace taut {

/// The surface of a solid out of triangles, in axes of its own, with a tree of boxes around them. It must be
/// closed, cross itself nowhere, and face outwards; who reads meshes sees to that. Distances from it are
/// exact: there is no grid that they are read from.
class SolidMesh {
 public:
  using Corners = std::array<Index, 3>;

  /// An edge, and the triangles beside it.
  struct Edge {
    std::array<Index, 2> ends{};
    std::array<Index, 2> triangles{};
    bool ridge = false;  ///< whether the surface is bent outwards over it, so that it can be struck
  };

  /// Takes over a surface, and sorts its parts so that what is near each other stands near each other.
  SolidMesh(const std::vector<Vec3>& vertices, const std::vector<Corners>& triangles);

  const std::vector<Vec3>& vertices() const { return vertices_; }       ///< m
  const std::vector<Corners>& triangles() const { return triangles_; }  ///< facing outwards
  const std::vector<Edge>& edges() const { return edges_; }             ///< of two triangles each
  /// Which of the triangles that it was made from each one is.
  const std::vector<Index>& made_from() const { return made_from_; }
  const Bounds& bounds() const { return nodes_.front().box; }

  /// The nearest place of the surface. On which side of it a point is says the normal there: that of a
  /// triangle, the sum of the two beside an edge, or at a corner that of all around it, each by its angle
  /// (Bærentzen and Aanæs, Signed Distance Computation Using the Angle Weighted Pseudonormal, 2005).
  Surface nearest(const Vec3& point) const;

  /// The same where the distance is below `reach` (m), as it is of all that is inside; of what is farther
  /// away little is looked at.
  std::optional<Surface> within(const Vec3& point, double reach) const;

  /// Where a straight way first leads from outside into the solid, and whether it leads out of it anywhere.
  struct Crossing {
    bool enters = false, leaves = false;
    Vec3 place = Vec3::Zero();    ///< m, where it enters
    Vec3 normal = Vec3::UnitY();  ///< of the triangle there
  };
  Crossing crossing(const Vec3& from, const Vec3& to) const;

  /// Calls visit(triangle) for each one whose box meets another.
  template <class Visit>
  void visit_near(const Bounds& box, const Visit& visit) const {
    visit_boxes([&](const Bounds& each) { return each.meets(box); }, visit);
  }

  /// How often a straight way goes through triangles that `counts(triangle)` says yes of.
  template <class Counts>
  int crossings(const Vec3& from, const Vec3& to, const Counts& counts) const {
    int count = 0;
    const Bounds along = bounds_of(from, to);
    visit_near(along, [&](Index triangle) {
      if (counts(triangle) && crossed_at(triangle, from, to)) ++count;
    });
    return count;
  }

  std::array<Vec3, 3> corners_of(Index triangle) const {
    const Corners& c = triangles_[triangle];
    return {vertices_[c[0]], vertices_[c[1]], vertices_[c[2]]};
  }

 private:
  // A box around some of the triangles. A leaf holds triangles, others hold the two nodes that follow.
  struct Node {
    Bounds box;
    std::uint32_t first = 0, count = 0;
  };
  // The nearest place found so far: in a triangle (part 0), on its edge from corner part − 1 (1 to 3), or at
  // its corner part − 4.
  struct Found {
    double square = 0.0;  // m²
    Index triangle = 0xffffffffU;
    int part = 0;
    Vec3 place = Vec3::Zero();

    bool any() const { return triangle != 0xffffffffU; }
  };

  static Bounds bounds_of(const Vec3& a, const Vec3& b);
  void sort_triangles(const std::vector<Vec3>& vertices, const std::vector<Corners>& triangles);
  void take_vertices(const std::vector<Vec3>& vertices, const std::vector<Corners>& triangles);
  void find_edges();
  void find_normals();
  void look(Index triangle, const Vec3& point, Found& best) const;
  void search(const Vec3& point, Found& best) const;
  Surface surface_at(const Vec3& point, const Found& found) const;
  std::optional<double> crossed_at(Index triangle, const Vec3& from, const Vec3& to) const;

  template <class Meets, class Visit>
  void visit_boxes(const Meets& meets, const Visit& visit) const {
    std::array<std::uint32_t, 128> open{};  // halved at the median: no tree is deeper than half of that
    std::size_t opened = 1;
    while (opened > 0) {
      const Node& node = nodes_[open[--opened]];
      if (!meets(node.box)) continue;
      if (node.count == 0) {
        open[opened++] = node.first + 1;
        open[opened++] = node.first;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(i);
    }
  }

  std::vector<Vec3> vertices_;
  std::vector<Corners> triangles_;
  std::vector<Index> made_from_;
  std::vector<Edge> edges_;
  std::vector<Node> nodes_;
  std::vector<Vec3> face_normals_, corner_normals_;  // unit length; of triangles and vertices
  std::vector<std::array<Vec3, 3>> edge_normals_;    // of each triangle, that from corner k on
  double size_ = 0.0;                                // m, across
  std::optional<InsideGrid> inside_;
};

}  // namespace taut
