#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/colour_scale.h"
#include "geometry/lattice.h"
#include "geometry/link_runs.h"

namespace taut {

/// A chain's ring, two half circles and what is straight between them, as shaders/ring.vert reads it.
struct RingRecord {
  glm::vec3 start;    ///< m, where it bears on the ring before
  float wire_radius;  ///< m
  glm::vec3 end;      ///< m, and on the next one
  float bend_radius;  ///< m, of the half circles, to the middle of the wire
  glm::vec3 side;     ///< unit vector in the ring's plane, across its length
  Rgba colour;
};

/// Runs of links as rings that go through each other, each turned by a right angle against the one before
/// (state in picture space): a ring a link, or one each `look.chain_pitch`, which is made to fit.
std::vector<RingRecord> chain_rings(const Drawn& drawn, const std::vector<LinkRun>& runs);

}  // namespace taut
