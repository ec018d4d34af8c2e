#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "base/image.h"
#include "geometry/colour_scale.h"
#include "geometry/fineness.h"
#include "geometry/mesh_cloth.h"
#include "geometry/mesh_topology.h"
#include "geometry/sheet_lattice.h"
#include "geometry/surface_records.h"
#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// The sheets of a model spread out flat below each other, to work out on them how much light arrives.
struct SpreadSheets {
  Size places{0, 0};               ///< vertices that all sheets take, in each direction
  std::vector<glm::uvec2> sheets;  ///< places of each sheet, which begins at the left, below the one before
  glm::vec2 cell_size{0.0F};       ///< m, of the largest parts of cells
  MeshBlocks blocks;               ///< of the triangles of meshes, below all sheets
};

/// A broken link as the mass at one end sees it: cloth goes on from there as far as the tear.
struct CutEdge {
  Index mass = 0;
  Index seed = 0;                  ///< its own, whatever else tears
  float share = 0.5F;              ///< of the link's length that stays with the mass
  float length = 0.0F;             ///< m, of the whole link at rest
  std::array<glm::uvec2, 3> like;  ///< links beside it that are whole, from mass to mass, and go its way
  int like_count = 0;
  glm::vec3 at_start{0.0F};  ///< m, its way to the other end at the start, in the world's axes
  Index beside = 0;  ///< a mass that a whole link crosswise leads to; the same mass where there is none
  glm::vec3 beside_at_start{0.0F};  ///< m, the way to it
};

/// The middle of a cell that is torn, as a part of its corners sees it that whole links join.
struct CutMiddle {
  std::array<Index, 4> corners;  ///< masses, as SheetLattice::corners
  std::array<bool, 4> joined;    ///< those of the part
  std::array<Index, 4> cuts;     ///< along each edge that is broken: the first of its two ends' CutEdges
  glm::vec2 place;               ///< in the cell, from its top left corner
  Index mass = 0;                ///< one of the part
};

/// A place on the ragged line between a cut edge and the middle of a cell.
struct CutCorner {
  Index middle = 0, edge = 0;  ///< numbers of CutMiddle and CutEdge
  float along = 0.0F;          ///< from the middle, 0 to 1
  float aside = 0.0F;          ///< in lengths of the edge, along it and away from its mass
};

/// What of the cloth is drawn, for as long as nothing tears. Vertices: each sheet's fine_size(), row after
/// row; then one a cut edge, one a middle, one a corner; then those of meshes.
struct SurfaceTopology {
  std::vector<bool> broken;  ///< by link: what it holds for
  SharedIndices indices;
  SharedPlaces places;                ///< one a vertex
  std::vector<Index> mass_triangles;  ///< cells that are whole, by their masses
  std::vector<CutEdge> edges;
  std::vector<CutMiddle> middles;
  std::vector<CutCorner> corners;
  std::size_t sheet_indices = 0;   ///< so many of the indices, and …
  std::size_t sheet_vertices = 0;  ///< … of the vertices are of sheets and their tears
  MeshTopology meshes;
};

/// What never changes about the sheets and meshes of a model that are drawn as cloth.
struct Cloth {
  std::vector<SheetLattice> sheets;
  MeshCloth meshes;
  Fineness fineness;
  std::vector<glm::vec2> units;     ///< of the pattern a cell, for each sheet
  std::vector<float> hems;          ///< m, how wide each sheet's hem is; 0: none
  std::vector<SurfaceTint> tints;   ///< of each sheet; empty where all have the look's colours
  std::vector<glm::vec3> at_start;  ///< m, each mass, in the world's axes
  std::shared_ptr<const SpreadSheets> spread;
  std::vector<Index> groups;  ///< for each mass, one near it that stands for it where light is hidden
  float nearby = 0.0F;        ///< m, so far cloth and other things hide light from it
};

Cloth cloth_of(const Model& model, const State& start, const Look& look, float pixels_a_metre);

/// The topology of a state: `before`, where nothing has torn since. Where links along rows and columns are
/// broken, cells are cut from the link to their middle, along a ragged line that is the same from both sides:
/// cloth is parted there and none of it lost.
std::shared_ptr<const SurfaceTopology> surface_topology(
    const Cloth& cloth, const State& state, const std::shared_ptr<const SurfaceTopology>& before = {});

}  // namespace taut
