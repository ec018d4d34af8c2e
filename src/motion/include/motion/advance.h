#pragma once

#include "methods/method.h"

namespace taut {

/// What happens when a step fails.
struct Guard {
  bool on = true;  ///< off: the failed step's report is returned at once (and simulate() lets steps that make
                   ///< energy out of nothing pass, too)
  int most_halvings = 12;  ///< how often in a row a step may be halved
};

/// Moves the state on by h seconds: one step, halved and tried again where it fails, then the test of every
/// link against its thresholds (all over theirs break at once, in file order). When the report's status is
/// not `done`, the state is as it was at the start of the call.
StepReport advance(Stepper& stepper, const Model& model, State& state, double h, const Guard& guard = {});

/// The failure of a step as a sentence that names time, step and link and says what to try.
std::string failure_sentence(const Model& model, const State& state, const StepReport& report,
                             std::string_view method, double h);

}  // namespace taut
