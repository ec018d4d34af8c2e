#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/colour_scale.h"
#include "geometry/lattice.h"
#include "geometry/shade_tiles.h"
#include "geometry/solid_surface.h"
#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// A box as shaders/box.vert reads it.
struct BoxRecord {
  glm::vec3 centre;    ///< m
  glm::vec3 edges[3];  ///< m, from the centre to the middle of three faces
  Rgba colour;
  glm::vec3 shade{0.0F};  ///< its tile's first texel, and cells of that a face, each way
};

/// The hull of two balls, as shaders/rod.vert reads it: a ball where they are one. Each ball is squeezed:
/// what is at p from its centre is drawn at p − squeeze (squeeze · p), so that it is 1 − |squeeze|² as thick
/// in that direction; none, and it is round.
struct TaperedRod {
  glm::vec3 start;     ///< m
  float start_radius;  ///< m
  glm::vec3 end;       ///< m
  float end_radius;    ///< m
  glm::vec3 squeeze;   ///< shorter than 1
  Rgba start_colour, end_colour;
  glm::vec2 shade = no_shade;  ///< its tile's first texel
};

/// A trunk (torso.h) in its own axes, as shaders/torso.vert reads it.
struct TorsoRecord {
  glm::vec3 origin;   ///< m
  glm::vec3 axes[3];  ///< m
  Rgba colour;
  glm::vec2 shade = no_shade;  ///< its tile's first texel
};

/// What is drawn as rods, balls, trunks, boxes and meshes.
struct Bodies {
  std::vector<TaperedRod> rods;
  std::vector<TorsoRecord> torsos;
  std::vector<BoxRecord> boxes;
  std::vector<MeshRecord> meshes;
  ShadeTiles shades;  ///< what keeps light from all around from them, where that is shown

  bool empty() const { return rods.empty() && torsos.empty() && boxes.empty() && meshes.empty(); }
};

/// A rod of one colour. It is round.
TaperedRod tapered_rod(const Vec3& start, double start_radius, const Vec3& end, double end_radius,
                       const Colour& colour);
/// A ball that is `thickness` times as thick as it is wide along an axis (unit length).
TaperedRod squeezed_ball(const Vec3& centre, double radius, const Vec3& axis, double thickness,
                         const Colour& colour);

/// Adds a solid out of a mesh, of which that is drawn.
void add_mesh(Bodies& bodies, const MeshSolid& solid, const std::shared_ptr<const SolidSurface>& surface,
              const Colour& colour);

/// Adds something to hit; nothing for a plane, or for a mesh.
void add_shape(Bodies& bodies, const Shape& shape, const Colour& colour);

/// Adds a box at each mass that is drawn by itself, turned as its links have turned since the start.
void add_mass_boxes(Bodies& bodies, const State& start, const Drawn& drawn);

}  // namespace taut
