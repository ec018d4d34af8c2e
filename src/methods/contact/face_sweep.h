#pragma once

#include <vector>

#include "model/face_pairs.h"

namespace taut {

/// How far (m) a pair's two can come nearer to each other while all nodes move straight from start to end:
/// the largest way of a node of the one, as seen from the mean of all four, plus that of the other.
double most_approach(const FacePair& pair, const std::vector<Vec3>& start, const std::vector<Vec3>& end);

/// A pair on its way, where it came too near.
struct FaceMeeting {
  bool met = false;
  FaceGap gap;  ///< at the last moment before
};

/// Whether the distance of a pair comes to `stop` (m; no if it begins there) while all nodes move
/// straight from start to end. Never says no where it does: additive continuous collision detection (Li,
/// Kaufman and Jiang, Codimensional Incremental Potential Contact, 2021, algorithm 1). Each of its moves goes
/// as far as the two can't have met yet,
///   t ← t + 0.9 (distance(t) − stop)/most_approach,
/// until that is over or the distance has come to within a tenth of the first one's excess. There are no
/// polynomials to be solved, so nothing is lost in their rounding.
FaceMeeting first_meeting(const FacePair& pair, const std::vector<Vec3>& start, const std::vector<Vec3>& end,
                          double distance_at_start, double stop);

}  // namespace taut
