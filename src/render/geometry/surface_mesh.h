#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "base/image.h"
#include "geometry/colour_scale.h"
#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// One vertex of the cloth as shaders/surface.vert reads it.
struct SurfaceVertex {
  glm::vec3 position;  ///< m
  glm::vec3 normal;    ///< unit vector, on the front side
  float hollow;        ///< −1 to 1: above 0 where the front side is hollow, below where it bulges
};

/// Corners of triangles, three each, that several frames may share.
using SharedIndices = std::shared_ptr<const std::vector<Index>>;

/// Where in a look's pattern each mass of a sheet is: one unit a square of the checker or a thread of the
/// weave. Shared by all frames.
using SharedPattern = std::shared_ptr<const std::vector<glm::vec2>>;

/// The sheets of a model spread out flat below each other, to work out on them how much light arrives.
struct SpreadSheets {
  std::vector<glm::vec2> positions;  ///< of each mass, in cells of its sheet
  Size masses{0, 0};                 ///< that all sheets take, in each direction
  glm::vec2 cell_size{0.0F};         ///< m, of the largest cells
};

SpreadSheets spread_sheets(const Model& model, const State& start);

/// Vertices (one a mass, in the masses' order) and the triangles that are whole.
struct SurfaceMesh {
  std::vector<SurfaceVertex> vertices;
  std::vector<Rgba> colours;  ///< in place of the cloth's own; empty where masses have none
  SharedPattern pattern;
  std::shared_ptr<const SpreadSheets> spread;
  SharedIndices indices;
};

/// A triangle is whole while none of its edges is a broken link.
bool is_whole(const Triangle& triangle, const State& state);

/// The triangles that are whole: `before`, where it says the same.
SharedIndices whole_triangles(const Model& model, const State& state, const SharedIndices& before = {});

SharedPattern pattern_positions(const Model& model, Pattern pattern);

/// The mesh of a state, with normals and hollows smoothed over the whole triangles about each mass; but for
/// pattern and spread sheets.
SurfaceMesh surface_mesh(const SharedIndices& triangles, const State& state, const Quantity& quantity,
                         const ColourScale& scale);

/// For each place of spread sheets, row by row, where the shadow map is to be looked up for it, and the depth
/// that light must reach there. `to_map` takes picture space to the map, `to_light` is a unit vector, and
/// `texel` (m) the map's: by that much places are lifted off their own shadow, towards the side that is lit.
std::vector<glm::vec4> light_places(const SurfaceMesh& mesh, const glm::mat4& to_map,
                                    const glm::vec3& to_light, float texel);

}  // namespace taut
