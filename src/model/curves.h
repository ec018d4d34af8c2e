#pragma once

#include <optional>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// A smooth curve through points of which no two neighbours are alike, as a line of short straight pieces:
/// Catmull and Rom's, with knots as far apart as the roots of the distances, so that it has no loops of its
/// own (Yuksel and others, On the parameterization of Catmull-Rom curves, 2009).
std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points);

/// What a line is wound around.
struct Spool {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< m, the ends of its axis
  double radius = 0.0;                          ///< m
  bool round = false;                           ///< a ball, whose poles the axis ends at; else a cylinder
};

/// A line wound around a spool from one share of its axis to another, in short straight pieces; right-handed
/// about the axis where the turns are positive.
std::vector<Vec3> winding(const Spool& spool, double turns, double start, double end);

/// Places on a line of straight pieces, from its beginning to its end, so many chords apart, all of one
/// length (m). Nothing where it turns so sharply that no such length was found.
std::optional<std::vector<Vec3>> spread_evenly(const std::vector<Vec3>& line, int chords);

}  // namespace taut
