#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "base/image.h"
#include "base/vectors.h"
#include "geometry/colour_scale.h"

namespace taut {

/// Corners of triangles, three each, that several frames may share.
using SharedIndices = std::shared_ptr<const std::vector<Index>>;

/// What a vertex of the cloth keeps for as long as nothing tears, as shaders/surface.vert reads it.
struct SurfacePlace {
  glm::vec2 pattern;  ///< one unit a square of the checker or a thread of the weave
  glm::vec3 edges;    ///< xy: from the nearest upright and level border, in widths of a hem, or far away
                      ///< without one; z: 0 on a torn edge, 1 half a cell from it
  glm::vec2 light;    ///< in places of the sheets spread out flat
};
using SharedPlaces = std::shared_ptr<const std::vector<SurfacePlace>>;

/// The colours of both sides of the cloth at a vertex, as shaders/surface.vert reads them.
struct SurfaceTint {
  Rgba front, back;
};

/// One vertex of the cloth as shaders/surface.vert reads it.
struct SurfaceVertex {
  glm::vec3 position;  ///< m
  glm::vec3 normal;    ///< unit vector, on the front side
  glm::vec2 open;      ///< how bright light from all around makes its front (x) and its back (y)
};

/// A number from −1 to 1 that looks like chance, always the same for the same seeds.
float jitter(Index seed, Index salt);

/// How many parts a side of so many pixels is drawn in, where bends of so many are worth it.
Index parts_of(float pixels, float worth);

}  // namespace taut
