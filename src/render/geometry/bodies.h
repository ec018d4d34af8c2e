#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/colour_scale.h"
#include "geometry/lattice.h"
#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// A box as shaders/box.vert reads it.
struct BoxRecord {
  glm::vec3 centre;    ///< m
  glm::vec3 edges[3];  ///< m, from the centre to the middle of three faces
  Rgba colour;
};

/// What is drawn as rods, balls and boxes.
struct Bodies {
  std::vector<RodRecord> rods;  ///< with round ends; balls where both ends are one point
  std::vector<BoxRecord> boxes;
};

/// Adds the bones of ragdolls, and balls of a colour of their own at their joints.
void add_bones(Bodies& bodies, const Model& model, const State& state, const Look& look,
               const Quantity& quantity, const ColourScale& scale);

/// Adds something to hit; nothing for a plane.
void add_shape(Bodies& bodies, const Shape& shape, const Colour& colour);

/// Adds a box at each mass that is in no ragdoll, turned as its links have turned since the start.
void add_mass_boxes(Bodies& bodies, const Model& model, const State& start, const State& state,
                    const Look& look, const Radii& radii, const Quantity& quantity, const ColourScale& scale);

}  // namespace taut
