#pragma once

#include "methods/method.h"

namespace taut {

/// The parameter every method has: how many steps it makes a second.
constexpr Param steps_per_second_param(double fallback) {
  return {"steps_per_second", "1/s", fallback, 1.0, 1e7, false, {}, "steps per second of simulated time"};
}

/// The parameter of every relaxation method: how often it goes over all links in a step.
constexpr Param passes_param(double fallback) {
  return {"passes", "", fallback, 1.0, 1e6, true, {}, "passes over all links in each step"};
}

}  // namespace taut
