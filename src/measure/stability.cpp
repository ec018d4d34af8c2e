#include "measure/stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/failure.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "motion/run.h"

namespace taut {
namespace {

constexpr double drift = 0.01;  // energy scales
constexpr std::int64_t instants = 20;

// Methods that know no tensions don't know the work of driven pins, so their energy can't be judged there.
bool knows_pin_work(const Model& model, const Method& method) {
  return method.can.tension_order > 0 || model.driven_pins.empty();
}

// |gain − work done| over the energy scale; 0 where there is nothing to compare with, as in a scene at rest
// without weight.
double drift_of(const Model& model, const Run& run) {
  const bool known = knows_pin_work(model, *find_method(run.settings().method));
  return known ? std::abs(run.measures(run.state()).energy_error) : 0.0;
}

RunOutcome watch(Run& run, const Model& model, std::int64_t steps, const State* reference,
                 std::int64_t compare_after) {
  RunOutcome outcome;
  for (std::int64_t step = 1; step <= steps; ++step) {
    const bool made = run.step() && (step < steps || run.holds_together());
    outcome.status = run.report().counts.status;
    outcome.steps = run.steps();
    if (!made) {
      outcome.fate = Fate::diverged;
      return outcome;
    }
    if (step * instants / steps > (step - 1) * instants / steps) {
      outcome.strain = std::max(outcome.strain, link_strain(model, run.state()).largest);
      outcome.energy_drift = std::max(outcome.energy_drift, drift_of(model, run));
    }
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
  std::optional<Run> run;
  try {
    run.emplace(model, start, settings, unguarded);
  } catch (const BadRequest&) {
    RunOutcome refusal;
    refusal.fate = Fate::refused;
    return refusal;
  }
  return watch(*run, model, steps, reference, compare_after);
}

}  // namespace taut
