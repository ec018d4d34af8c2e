#include "motion/simulate.h"

namespace taut {

RunReport simulate(const Model& model, State& state, const Settings& settings, std::int64_t steps,
                   const RunPolicy& policy, const StopTest& stop) {
  Run run(model, state, settings, policy);
  while (run.steps() < steps && run.step()) stop_if_told(stop);
  run.holds_together();
  state = run.state();
  return run.report();
}

SampledRun sampled_run(const Model& model, const State& start, const Settings& settings,
                       const std::vector<double>& times, const RunPolicy& policy, const StopTest& stop) {
  return sampled_run(Run(model, start, settings, policy), times, stop);
}

SampledRun sampled_run(Run run, const std::vector<double>& times, const StopTest& stop) {
  SampledRun sampled;
  for (const double time : times) {
    const std::optional<State> state = run.at(time, throwing(stop));
    if (!state) break;
    sampled.states.push_back(run.reported(*state));
  }
  sampled.report = run.report();
  sampled.reached = run.state().time;
  sampled.failure = run.failure();
  return sampled;
}

}  // namespace taut
