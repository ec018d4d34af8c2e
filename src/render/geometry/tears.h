#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geometry/surface_topology.h"

namespace taut {

/// A cell's part of the vertices of its sheet.
struct FineCell {
  Fineness fineness;
  Index width = 0;  ///< vertices of a row of the sheet
  Index first = 0;  ///< the vertex at its top left corner

  Index vertex(Index across, Index down) const { return first + down * width + across; }
};

/// A cell with a broken edge.
struct TornCell {
  std::size_t sheet = 0;  ///< its number
  Index row = 0, column = 0;
  FineCell cell;
};

/// What a vertex of a sheet keeps: `at` in cells from its top left corner, `light` in places.
SurfacePlace place_on_sheet(const Cloth& cloth, std::size_t sheet, const glm::vec2& at,
                            const glm::vec2& light);

/// Cuts torn cells: adds cut edges, middles and corners to a topology whose `broken` is known, their
/// vertices' places to `places`, and the triangles between them to `indices`.
void cut(SurfaceTopology& topology, const Cloth& cloth, std::span<const TornCell> torn,
         std::vector<SurfacePlace>& places, std::vector<Index>& indices);

/// Where the vertices of tears are, in the order of the topology's edges, middles and corners: `masses` (m)
/// in picture space, which `to_picture` turns the world's axes to.
std::vector<glm::vec3> places_of_tears(const SurfaceTopology& topology, std::span<const glm::vec3> masses,
                                       const glm::mat3& to_picture);

/// The way (m) that a whole link would go from the mass of a cut edge.
glm::vec3 way_of(const CutEdge& edge, std::span<const glm::vec3> masses, const glm::mat3& to_picture);

/// Masses that the vertices of tears, in their order, hang on.
std::vector<Index> masses_of_tears(const SurfaceTopology& topology);

}  // namespace taut
