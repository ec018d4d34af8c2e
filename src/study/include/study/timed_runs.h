#pragma once

#include <cstdint>
#include <vector>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// How long the same run took, again and again (s).
struct RunTimes {
  std::vector<double> wall;       ///< by the clock
  std::vector<double> processor;  ///< of this thread's processor: the same on a free core, and still right on
                                  ///< a busy one
};

/// Times a run of so many steps five times, pinned to one processor, with no output; at least twice and then
/// no more once `enough` seconds are spent. The caller has run the same before, so that nothing is cold.
RunTimes time_runs(const Model& model, const State& start, const Settings& settings, std::int64_t steps,
                   double enough);

}  // namespace taut
