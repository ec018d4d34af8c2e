#pragma once

#include "measure/truth.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What is true of a scene's end where no motion can be certified: its sag, energy and largest strain at a
/// horizon (s). Every method that can do the scene runs with ever finer steps, as far as `most_seconds` of
/// one run go (as predicted_seconds() has it); the two of different kinds that agree best with themselves at
/// half the step and with each other are taken. Errors are judged down to ten times what they differ by; a
/// kind whose limit lies above 10 % is not judged. Where links break on the way the horizon is cut to before
/// the first break, and where no two methods agree at all `smallest` is empty; the remark says so. `why`
/// there is no motion begins it.
Truth truth_by_agreement(const Model& model, const State& start, double horizon, double most_seconds,
                         const std::string& why);

}  // namespace taut
