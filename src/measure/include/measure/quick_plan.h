#pragma once

#include <optional>
#include <string_view>

#include "base/stop.h"
#include "measure/plan.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Plans a run of `duration` seconds by rule, within a second for 10⁴ links: what theory knows of how fast
/// things happen in the scene (time_scales.h) gives each method that can do it a first step, and a few short
/// runs with the steps around it, each compared with the one of half the step and with other methods, tell
/// which is the cheapest that is good enough. Where that many steps of the whole scene take too long, only
/// its beginning is run, and then the step is never coarser than the rule's or the method's default. `only`:
/// a method that the plan has to use; empty: any. `most_seconds`: what the short runs may cost, predicted;
/// absent: a fifth of a second, more for more than 10⁴ links. Decided by counts alone, never by a clock: the
/// same scene gets the same plan everywhere. Throws BadRequest where no method can do the scene, Interrupted.
Plan quick_plan(const Model& model, const State& start, double duration, const AccuracyTarget& target,
                std::string_view only = {}, const StopTest& stop = {},
                std::optional<double> most_seconds = {});

}  // namespace taut
