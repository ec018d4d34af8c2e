#include "measure/stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/failure.h"
#include "motion/work_ledger.h"
#include "model/measures.h"
#include "motion/run_measures.h"
#include "methods/registry.h"
#include "motion/simulate.h"

namespace taut {
namespace {

constexpr double drift = 0.01;  // energy scales
constexpr std::int64_t instants = 20;

// Methods that know no tensions don't know the work of driven pins, so their energy can't be judged there.
bool knows_pin_work(const Model& model, const Method& method) {
  return method.can.break_tension || model.driven_pins.empty();
}

// A run of one method with what is watched of it.
class WatchedRun {
 public:
  WatchedRun(const Model& model, const State& start, const Method& method, Stepper& stepper)
      : model_(model),
        method_(method),
        stepper_(stepper),
        state_(start),
        ledger_(model, start),
        energy_at_start_(energy(model, start).total()),
        scale_(knows_pin_work(model, method) ? energy_scale(model, start) : 0.0) {}

  const State& state() const { return state_; }

  // One step that ends at a time; false when that was the end of the run.
  bool step(double h, double end_time, RunOutcome& outcome) {
    outcome.status = advance(stepper_, model_, state_, h, {.on = false}).status;
    if (outcome.status == StepStatus::done) {
      state_.time = end_time;
      ledger_.record(state_);
      ++outcome.steps;
      if (!(relative_gain(state_) > divergence)) return true;
    }
    outcome.fate = Fate::diverged;
    return false;
  }

  void measure(RunOutcome& outcome) const {
    outcome.strain = std::max(outcome.strain, link_strain(model_, state_).largest);
    const double gain = std::abs(relative_gain(reported_state(model_, method_.can, state_)));
    outcome.energy_drift = std::max(outcome.energy_drift, gain);
  }

 private:
  // 0 where there is nothing to compare with, as in a scene at rest without weight.
  double relative_gain(const State& state) const {
    if (!(scale_ > 0.0)) return 0.0;
    return (energy(model_, state).total() - energy_at_start_ - ledger_.expected_gain()) / scale_;
  }

  const Model& model_;
  const Method& method_;
  Stepper& stepper_;
  State state_;
  WorkLedger ledger_;
  double energy_at_start_, scale_;  // J
};

RunOutcome watch(WatchedRun& run, double rate, std::int64_t steps, const State* reference,
                 std::int64_t compare_after) {
  RunOutcome outcome;
  const double start_time = run.state().time;
  for (std::int64_t step = 1; step <= steps; ++step) {
    if (!run.step(1.0 / rate, start_time + static_cast<double>(step) / rate, outcome)) return outcome;
    if (step * instants / steps > (step - 1) * instants / steps) run.measure(outcome);
    if (reference != nullptr && step == compare_after)
      outcome.error = position_error(run.state(), *reference);
  }
  outcome.fate = outcome.energy_drift > drift ? Fate::drifted : Fate::held;
  return outcome;
}

}  // namespace

std::string_view fate_name(Fate fate) {
  constexpr std::array<std::string_view, 4> names{"held", "drifted", "diverged", "refused"};
  return names[static_cast<std::size_t>(fate)];
}

RunOutcome run_unguarded(const Model& model, const State& start, const Settings& settings, std::int64_t steps,
                         const State* reference, std::int64_t compare_after) {
  RunOutcome refusal;
  refusal.fate = Fate::refused;
  const Settings complete = complete_settings(settings);
  const Method& method = *find_method(complete.method);
  if (!capability_problems(model, method).empty()) return refusal;
  std::unique_ptr<Stepper> stepper;
  try {
    stepper = method.make(model, complete);
    stepper->watch_energy(false);
    stepper->links_changed(start);
  } catch (const BadRequest&) {
    return refusal;
  }
  WatchedRun run(model, start, method, *stepper);
  return watch(run, complete.steps_per_second(), steps, reference, compare_after);
}

}  // namespace taut
