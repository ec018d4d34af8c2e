#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What is true of a scene at some times, and how far to trust it.
struct Reference {
  std::vector<State> states;  ///< one a time asked for; empty when refused
  double uncertainty =
      0.0;  ///< m, the larger of the change by halving the step and the distance to the second opinion
  double certified_until =
      0;                ///< s, the last time asked for up to which `uncertainty` stays below the demand
  std::string how;      ///< what it was made with, for people
  std::string refusal;  ///< why there is none; empty when there is

  bool certified() const { return refusal.empty(); }
};

/// The motion at rising times, certified to `accuracy` (m): the step of rattle (of order 4 where the scene
/// allows it) is halved until that changes no position by more than a third of it, and an explicit
/// integration of the equations at acceleration level, at two tolerances, must agree within it. Where
/// agreement ends before the last time the later states are left out, and certified_until says so; so it is
/// where the first event comes (events.h), as neither opinion resolves any. Refused, with the reason, where
/// no state can be certified.
Reference make_reference(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy);

}  // namespace taut
