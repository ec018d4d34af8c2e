#pragma once

#include <string>
#include <vector>

#include "base/stop.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What is true of a scene at some times, and how far to trust it.
struct Reference {
  std::vector<State> states;     ///< one a time asked for; empty when refused
  double uncertainty = 0.0;      ///< m, the largest distance between any two of the runs it is made of
  double certified_until = 0.0;  ///< s, the last time asked for up to which that stays below the demand
  std::string how;               ///< what it was made with, for people
  std::string refusal;           ///< why there is none; empty when there is

  bool certified() const { return refusal.empty(); }
};

/// The motion at rising times, certified to `accuracy` (m) by two kinds of witness: dop853 at two tolerances,
/// and rattle, of order 4 where the scene allows it, with ever shorter steps, must agree within it. Both go
/// on past breaks and stops, whose moments they locate each in its own way. Where agreement ends before the
/// last time the later states are left out, and certified_until says so; so it is where the first event comes
/// that neither resolves (events.h). No run may cost more than `most_seconds` (as predicted_seconds() has
/// it). Refused, with the reason, where no state can be certified. Throws Interrupted.
Reference make_reference(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy, double most_seconds = 10.0, const StopTest& stop = {});

}  // namespace taut
