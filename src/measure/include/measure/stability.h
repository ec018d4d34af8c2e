#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// How a run with the guard off ended.
enum class Fate {
  held,      ///< finite to the end, its energy within 1 % of the energy scale
  drifted,   ///< finite to the end, its energy further off
  diverged,  ///< not finite, or a step could not be solved, or the masses moved with 10³ times the energy at
             ///< hand
  refused,   ///< the method says beforehand that it can't do the scene, or not with this step
};

/// What happened in a run with the guard off.
struct RunOutcome {
  Fate fate = Fate::held;
  StepStatus status = StepStatus::done;  ///< of the last step
  std::int64_t steps = 0;                ///< made
  double energy_drift = 0.0;  ///< largest |gain − work of pins and loads + energy of broken links| over the
                              ///< energy scale, of some instants spread over the run
  double strain = 0.0;        ///< largest |strain| of any whole link at those instants
  double error = std::numeric_limits<double>::quiet_NaN();  ///< m, from the reference; no number
                                                            ///< without a reference, or where it diverged
  bool failed() const { return fate == Fate::diverged || fate == Fate::refused; }
};

/// The name of a fate: held, drifted, diverged, refused.
std::string_view fate_name(Fate fate);

/// Runs the method as it is, nothing halved and no step refused for its energy, for a whole number of steps
/// of 1/steps_per_second, and says how it ended. The run stops as soon as it has diverged. `reference` is
/// where the masses ought to be after `compare_after` steps, or nullptr. A method that refuses the
/// run gives `refused`.
RunOutcome run_unguarded(const Model& model, const State& start, const Settings& settings, std::int64_t steps,
                         const State* reference = nullptr, std::int64_t compare_after = 0);

}  // namespace taut
