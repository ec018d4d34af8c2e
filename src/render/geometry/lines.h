#pragma once

#include <vector>

#include "geometry/chain_rings.h"
#include "geometry/lattice.h"
#include "geometry/picture_space.h"
#include "geometry/rope.h"
#include "render/trails.h"

namespace taut {

/// What is drawn of links as ropes and chains, and what explains a picture: loads and the exact shape.
struct Lines {
  std::vector<RopeRecord> ropes;
  std::vector<RingRecord> rings;
  std::vector<RodRecord> arrows;  ///< from tail to tip; the radius is the shaft's
  std::vector<RodRecord> ghosts;  ///< thin, throw no shadow, their colours' alpha counts

  bool empty() const { return ropes.empty() && rings.empty() && arrows.empty() && ghosts.empty(); }
};

/// How wide an arrow's head is, in radii of its shaft; see shaders/arrow.vert.
inline constexpr float arrow_head = 3.0F;

/// Calls visit(centre, radius) with balls (m) that hold all of it, each within its convex hull.
template <typename Visit>
void for_each_ball(const Lines& lines, const Visit& visit) {
  for (const RopeRecord& piece : lines.ropes) {
    visit(piece.start, piece.start_radius);
    visit(piece.end, piece.end_radius);
  }
  for (const RingRecord& ring : lines.rings)
    for (const glm::vec3& end : {ring.start, ring.end}) {
      visit(end - ring.side * ring.bend_radius, 2.0F * ring.wire_radius);
      visit(end + ring.side * ring.bend_radius, 2.0F * ring.wire_radius);
    }
  for (const RodRecord& arrow : lines.arrows) {
    visit(arrow.start, arrow_head * arrow.radius);
    visit(arrow.end, arrow_head * arrow.radius);
  }
  for (const RodRecord& ghost : lines.ghosts) {
    visit(ghost.start, ghost.radius);
    visit(ghost.end, ghost.radius);
  }
}

/// Adds links as ropes or chains where the look says so, with the balls that ropes end in.
void add_linked(Lines& lines, std::vector<SphereRecord>& balls, const Drawn& drawn);

/// Adds arrows of loads where the look says so; `size` (m): the scene's.
void add_loads(Lines& lines, const Drawn& drawn, const PictureSpace& space, double size);

/// Adds the links of another state, in picture space, as ghosts.
void add_ghost(Lines& lines, const Drawn& drawn, const State& other);

/// Adds trails, in the world's space, as lines that fade into the past.
void add_trails(Lines& lines, const Drawn& drawn, const PictureSpace& space, const Trails& trails);

}  // namespace taut
