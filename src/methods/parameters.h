#pragma once

#include "methods/method.h"

namespace taut {

inline constexpr double default_impact_passes = 256.0;

/// The parameter every method has: how many steps it makes a second.
constexpr Param steps_per_second_param(double fallback) {
  return {"steps_per_second", "1/s", fallback, 1.0, 1e7, false, {}, "steps per second of simulated time"};
}

/// The parameter of every relaxation method: how often it goes over all links in a step.
constexpr Param passes_param(double fallback) {
  return {"passes", "", fallback, 1.0, 1e6, true, {}, "passes over all links in each step"};
}

/// The parameter beside it of those that answer to stops and impacts.
constexpr Param impact_passes_param() {
  return {
      "impact_passes",
      "",
      default_impact_passes,
      1.0,
      1e6,
      true,
      {},
      "most passes in a step in which a stop or a solid pushes: beyond `passes` they go on until rigid links "
      "are about as good as before the step. Where only passes is given, there are just as many",
      "passes"};
}

/// How many passes a method with both makes in a step.
struct PassCounts {
  int ordinary = 1, impact = 1;
};
inline PassCounts pass_counts(const Settings& settings) {
  return {static_cast<int>(settings.number("passes")), static_cast<int>(settings.number("impact_passes"))};
}

}  // namespace taut
