#pragma once

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What theory knows of how fast things happen in a scene, before anything has moved (s); infinity for what
/// the scene has none of.
struct TimeScales {
  double fall = 0.0;      ///< √(l/g) of the mean link, of the scene's size where it has none: how long what
                          ///< gravity does to a link takes
  double sideways = 0.0;  ///< √(m l/T), the least of all rigid links: their fastest swing from side to side
  double spring = 0.0;  ///< 2/ω with ω a bound of the springs' highest frequency: the explicit step's limit
  double motion = 0.0;  ///< l/v with l the mean link and v the speed of the fastest pin, or of the fastest
                        ///< mass at the start relative to a neighbour
  double impact = 0.0;  ///< r/v with r the smallest radius of contact (or the mean link) and v the speed of a
                        ///< fall through the scene: how long what hits takes to go through its own size
};

/// For a run of so many seconds. The tension T is what the weight of the free masses and the loads comes to
/// at the pins' links, trebled: a pendulum let go level pulls with three times its weight at the bottom.
TimeScales time_scales(const Model& model, const State& start, double duration);

/// The distance (m) along links from the nearest pin (in each part without pins from its first mass) to the
/// mass that is farthest from any: what errors in the lengths of links add up along.
double longest_reach(const Model& model);

}  // namespace taut
