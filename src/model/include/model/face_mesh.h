#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "model/model.h"

namespace taut {

/// What faces are made of and what they can meet, as points, edges and triangles on the same nodes: those of
/// sheets with faces, single masses that touch other bodies, and those of solids. A ball is a point with a
/// radius, a capsule an edge with a radius, a box its corners, edges and twelve triangles, a mesh its own and
/// those of its edges that stand out; half-spaces have no part in it, for a triangle is in one exactly where
/// a corner of it is.
///
/// Two triangles that do not pass through each other can only come to do so when a corner of one meets the
/// other, or an edge of one an edge of the other: so what is kept apart are pairs of points and triangles,
/// and pairs of edges, that have no node in common.
struct FaceMesh {
  struct Edge {
    std::array<std::uint32_t, 2> nodes;
    std::array<std::uint32_t, 2>
        triangles;  ///< that it is an edge of; the same twice where it is of one only
  };
  /// Nodes that belong together: a sheet's, a solid's, or the balls of a body.
  struct Group {
    const SheetFaces* faces = nullptr;  ///< of a sheet
    const Collider* solid = nullptr;    ///< what it is, where it is one
    double friction = 0.5;
    Index body = no_body;  ///< touches those of other bodies
  };

  std::vector<Index> mass;        ///< of each node of a sheet, then of each ball; solids' follow without one
  std::uint32_t sheet_nodes = 0;  ///< how many of them are of sheets
  std::vector<Vec3> solid_place;  ///< m, of each node of a solid, as that stands in the model
  std::vector<double> inverse_mass;  ///< 1/kg of each node; 0 where it is pinned or a solid's
  std::vector<double>
      radius;  ///< m around each node that its contact keeps free: half a thickness, or a solid's
  std::vector<double> core;          ///< m, the part of that which is solid: 0 for a sheet
  std::vector<std::uint32_t> group;  ///< of each node
  std::vector<Group> groups;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Index> model_triangle;  ///< of each triangle of a sheet; those of solids follow
  /// Balls with nodes of sheets that a link joins them to, rising: those don't touch.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
  std::vector<Edge> edges;  ///< those of solids are edges of no triangle: their numbers are no_triangle

  static constexpr std::uint32_t no_triangle = 0xffffffffU;

  explicit FaceMesh(const Model& model);

  std::uint32_t size() const { return static_cast<std::uint32_t>(inverse_mass.size()); }
  bool of_solid(std::uint32_t node) const { return node >= mass.size(); }
  bool is_ball(std::uint32_t node) const { return node >= sheet_nodes && !of_solid(node); }
  /// Whether a point is a ball that a link joins to a corner of a triangle.
  bool joins(std::uint32_t point, const std::array<std::uint32_t, 3>& triangle) const;
  /// Whether a node is of a solid that moves.
  bool rides(std::uint32_t node) const { return of_solid(node) && groups[group[node]].solid->motion; }
  /// Where all nodes are at a time (s).
  void places(const Vectors& position, double time, std::vector<Vec3>& out) const;
  /// Whether what is of these two groups is kept apart.
  bool meet(std::uint32_t group_a, std::uint32_t group_b) const;
  /// Whether any faces are kept apart from faces, or from balls.
  bool any_meet() const;
};

/// The parts of a mesh that are whole: triangles without broken edges, their corners and edges, balls, and
/// all that is of solids.
struct WholeFaces {
  std::vector<std::uint32_t> points, edges, triangles;  ///< rising
};
WholeFaces whole_faces(const FaceMesh& mesh, const Model& model, const std::vector<double>& broken_at);

}  // namespace taut
