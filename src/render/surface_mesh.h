#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "colour_scale.h"
#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// One vertex of the cloth as shaders/surface.vert reads it.
struct SurfaceVertex {
  glm::vec3 position;  ///< m
  glm::vec3 normal;    ///< unit vector, on the front side
  glm::vec2 pattern_position;
  Rgba colour;   ///< alpha 255 where it replaces the cloth's own colour, else 0
  float hollow;  ///< −1 to 1: above 0 where the front side is hollow, below where it bulges
};

/// Vertices (one a mass, in the masses' order) and the triangles that are whole.
struct SurfaceMesh {
  std::vector<SurfaceVertex> vertices;
  std::vector<Index> indices;
};

/// A triangle is whole while none of its edges is a broken link.
bool is_whole(const Triangle& triangle, const State& state);

/// Coordinates of a look's pattern at each mass of a sheet: one unit a square of the checker or a thread of
/// the weave.
std::vector<glm::vec2> pattern_positions(const Model& model, Pattern pattern);

/// The mesh of a state, with normals and hollows smoothed over the whole triangles about each mass.
SurfaceMesh surface_mesh(const Model& model, const State& state, const std::vector<glm::vec2>& pattern,
                         const Quantity& quantity, const ColourScale& scale);

}  // namespace taut
