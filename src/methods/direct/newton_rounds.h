#pragma once

#include <vector>

#include "direct/link_system.h"

namespace taut {

/// The relative error in lengths that a direct solve is to reach: 1e-12, or where positions are so large
/// beside the links that rounding forbids it, 16 units in the last place of a position over the shortest
/// link.
double length_tolerance(const SystemLinks& links, const Vectors& position);
/// The same of the shortest link (m) and the largest coordinate of all positions (m).
double length_tolerance(double shortest, double farthest);

/// Length of the shortest link (m); 1 where there is none.
double shortest_length(const SystemLinks& links);

/// How many rounds of Newton's method a solve may take.
inline constexpr int most_newton_rounds = 30;
/// A solve that is further off than this after so many rounds wanders about until the rounds run out: halving
/// the step at once is cheaper (on 1000 light links with a heavy tip at 60 steps/s it saves half of all
/// rounds).
inline constexpr int rounds_to_settle = 6;
inline constexpr double settled_error = 0.05;

}  // namespace taut
