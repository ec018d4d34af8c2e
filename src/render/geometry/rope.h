#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/colour_scale.h"
#include "geometry/lattice.h"
#include "geometry/link_runs.h"

namespace taut {

/// A short piece of a rope as shaders/rope.vert reads it. Neighbours share ends and tangents, so that they
/// join without a seam.
struct RopeRecord {
  glm::vec3 start;                       ///< m
  float start_radius;                    ///< m
  glm::vec3 end;                         ///< m
  float end_radius;                      ///< m
  glm::vec3 start_tangent, end_tangent;  ///< unit vectors along the rope
  glm::vec2 phases;                      ///< rad, of the strands where the rope faces the eye, at either end
  Rgba start_colour, end_colour;
};

/// Runs of links as ropes, and what rounds off their ends.
struct Ropes {
  std::vector<RopeRecord> pieces;
  std::vector<SphereRecord> balls;  ///< at ends, and where ropes are tied together
};

/// Smooth ropes of three strands through the masses of runs (state in picture space). The strands keep to the
/// rope's material. Where a link has broken, a rope ends in loose strands. Colours go smoothly from link to
/// link; where they mean nothing a run has that of its first link.
Ropes ropes(const Drawn& drawn, const std::vector<LinkRun>& runs);

}  // namespace taut
