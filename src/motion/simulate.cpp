#include "motion/simulate.h"

#include "methods/registry.h"

namespace taut {

StepReport simulate(const Model& model, State& state, const Settings& settings, std::int64_t steps,
                    const Guard& guard) {
  const Settings complete = complete_settings(settings);
  const auto stepper = find_method(complete.method)->make(model, complete);
  stepper->watch_energy(guard.on);
  stepper->links_changed(state);
  const double rate = complete.steps_per_second();
  const double start_time = state.time;
  StepReport total;
  for (std::int64_t step = 1; step <= steps; ++step) {
    total.add(advance(*stepper, model, state, 1.0 / rate, guard));
    if (total.status != StepStatus::done) break;
    state.time = start_time + static_cast<double>(step) / rate;
  }
  return total;
}

}  // namespace taut
