#pragma once

#include <cstdint>
#include <vector>

#include "base/stop.h"
#include "motion/run.h"

namespace taut {

/// Makes so many steps from a state, the time after step n being n/steps_per_second later exactly. Ends early
/// where a step can't be solved; `state` is then the last good one. Throws as Run does, and
/// Interrupted.
RunReport simulate(const Model& model, State& state, const Settings& settings, std::int64_t steps,
                   const RunPolicy& policy = {}, const StopTest& stop = {});

/// One run and what it looked like at some times.
struct SampledRun {
  RunReport report;
  std::vector<State> states;  ///< one a time asked for, as reports show them; fewer when the run ended before
  double reached = 0.0;       ///< s
  std::string failure;        ///< why it ended before; empty when it didn't

  bool failed() const { return report.end != RunEnd::none; }
};

/// Runs a scene from its start through rising times (s), between two steps interpolated. Throws BadRequest
/// where the method refuses the run, and Interrupted.
SampledRun sampled_run(const Model& model, const State& start, const Settings& settings,
                       const std::vector<double>& times, const RunPolicy& policy = {},
                       const StopTest& stop = {});
/// The same of a run that is yet to begin, by whatever method and policy.
SampledRun sampled_run(Run run, const std::vector<double>& times, const StopTest& stop = {});

}  // namespace taut
