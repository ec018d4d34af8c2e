#pragma once

#include <optional>
#include <string>

#include "base/stop.h"
#include "model/state.h"
#include "scene/scene.h"

namespace taut {

/// A step that the scene's method was tried with, and held.
struct HoldingRate {
  double steps_per_second = 0.0;
  double tried_until = 0.0;  ///< s: the scene's end, or as far as a trial of about a second goes
};

/// The fewest steps per second (to 10 %) with which the scene's method gets through the time (s) at which it
/// failed, as the scene would be run: more than the scene's own are tried, each time twice as many, and the
/// last doubling is bisected; then that one is run on, and is only named if it holds, as far as tried_until.
/// Nothing where none is found with a few ten million solved links, a matter of seconds. Throws Interrupted.
std::optional<HoldingRate> holding_rate(const Scene& scene, double failed_at, const StopTest& stop = {});

/// What in the scene makes steps of a method fail, as a clause, where that can be told from the state that it
/// failed in: links of the wrong length at the start, pins as far apart as the links between them are long,
/// pins that move by whole links within a step. Empty where it is none of these.
std::string cause_of_failure(const Scene& scene, const State& failed);

/// What to say to the one whose run has failed, as the end of a sentence: the step that was found to hold,
/// and what seems to be the cause.
std::string failure_advice(const Scene& scene, const State& failed, const StopTest& stop = {});

}  // namespace taut
