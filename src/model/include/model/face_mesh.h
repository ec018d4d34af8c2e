#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/model.h"

namespace taut {

/// What faces are made of and what they can meet, as points, edges and triangles on the same nodes: those of
/// sheets with faces, and those of solids. A ball is a point with a radius, a capsule an edge with a radius,
/// a box its corners, edges and twelve triangles, a mesh its own and those of its edges that stand out;
/// half-spaces have no part in it, for a triangle is in one exactly where a corner of it is.
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
  /// Nodes that belong together: a sheet's, or a solid's.
  struct Group {
    const SheetFaces* faces = nullptr;  ///< of a sheet, or else …
    const Collider* solid = nullptr;    ///< … what it is
    double friction = 0.5;
  };

  std::vector<Index> mass;           ///< of each node of a sheet; those of solids follow, without one
  std::vector<Vec3> solid_place;     ///< m, of each node of a solid, as that stands in the model
  std::vector<double> inverse_mass;  ///< 1/kg of each node; 0 where it is pinned or a solid's
  std::vector<double>
      radius;  ///< m around each node that its contact keeps free: half a thickness, or a solid's
  std::vector<double> core;          ///< m, the part of that which is solid: 0 for a sheet
  std::vector<std::uint32_t> group;  ///< of each node
  std::vector<Group> groups;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Index> model_triangle;  ///< of each triangle of a sheet; those of solids follow
  std::vector<Edge> edges;  ///< those of solids are edges of no triangle: their numbers are no_triangle

  static constexpr std::uint32_t no_triangle = 0xffffffffU;

  explicit FaceMesh(const Model& model);

  std::uint32_t size() const { return static_cast<std::uint32_t>(inverse_mass.size()); }
  bool of_solid(std::uint32_t node) const { return node >= mass.size(); }
  /// Whether a node is of a solid that moves.
  bool rides(std::uint32_t node) const { return of_solid(node) && groups[group[node]].solid->motion; }
  /// Where all nodes are at a time (s).
  void places(const Vectors& position, double time, std::vector<Vec3>& out) const;
  /// Whether what is of these two groups is kept apart.
  bool meet(std::uint32_t group_a, std::uint32_t group_b) const;
  /// Whether any faces are kept apart from faces.
  bool any_meet() const;
};

/// The parts of a mesh that are whole: triangles without broken edges, their corners and edges, and all that
/// is of solids.
struct WholeFaces {
  std::vector<std::uint32_t> points, edges, triangles;  ///< rising
};
WholeFaces whole_faces(const FaceMesh& mesh, const Model& model, const std::vector<double>& broken_at);

}  // namespace taut
