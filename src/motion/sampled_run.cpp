#include "motion/sampled_run.h"

#include <algorithm>

#include "model/measures.h"
#include "motion/run_measures.h"
#include "methods/registry.h"

namespace taut {
namespace {

bool has_diverged(const Model& model, const State& state, double scale) {
  return !all_finite(state) || energy(model, state).kinetic > divergence * scale;
}

}  // namespace

SampledRun sampled_run(const Model& model, const State& start, const Settings& settings,
                       const std::vector<double>& times, const Guard& guard, const StopTest& stop) {
  const Method& method = *find_method(settings.method);
  const auto stepper = method.make(model, settings);
  stepper->links_changed(start);
  const double rate = settings.steps_per_second();
  const double scale = energy_scale(model, start);
  SampledRun run;
  State state = start, before = start;
  std::int64_t steps = 0;
  for (const double time : times) {
    while (static_cast<double>(steps) / rate < time) {
      stop_if_told(stop);
      // Copied only where it is needed, as a copy costs as much as a cheap step.
      const double next = static_cast<double>(steps + 1) / rate;
      if (next > time) before = state;
      run.report.add(advance(*stepper, model, state, 1.0 / rate, guard));
      run.diverged = run.report.status != StepStatus::done;
      if (run.diverged) break;
      ++steps;
      state.time = next;
    }
    run.reached = state.time;
    run.diverged = run.diverged || has_diverged(model, state, scale);
    if (run.diverged) break;
    const State shown =
        state.time == time ? state : interpolate(before, state, time, method.can.between_steps);
    run.states.push_back(reported_state(model, method.can, shown));
  }
  return run;
}

}  // namespace taut
