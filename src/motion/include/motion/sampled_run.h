#pragma once

#include <vector>

#include "base/stop.h"
#include "motion/advance.h"
#include "methods/method.h"

namespace taut {

/// One run and what it looked like at some times.
struct SampledRun {
  StepReport report;          ///< sums over all steps
  std::vector<State> states;  ///< one a time asked for, as reports show them; fewer when the run diverged
  double reached = 0.0;       ///< s
  bool diverged = false;  ///< a step failed, or something is not finite, or the masses have gained a thousand
                          ///< times the scene's energy scale
};

/// Runs a scene from its start with complete settings through rising times (s), between two steps
/// interpolated. Throws BadRequest where the method refuses these settings for this model, and
/// Interrupted.
SampledRun sampled_run(const Model& model, const State& start, const Settings& settings,
                       const std::vector<double>& times, const Guard& guard = {}, const StopTest& stop = {});

}  // namespace taut
