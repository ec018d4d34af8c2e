#pragma once

#include "measure/truth.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What is true of a scene's end where no motion can be certified: its sag, energy and largest strain at a
/// horizon (s). Where links break on the way, the horizon is cut to before the first break; ground and
/// breaking are then left out, so that every method can take part. Each runs with ever finer steps, as far as
/// `most_seconds` of one run go (as predicted_seconds() has it); the two methods that agree best, with
/// themselves at half the step and with each other, are taken. Errors are judged down to ten times what they
/// differ by; a kind whose limit would lie above 10 % is not judged. `smallest` is empty where no two agree,
/// and the remark says so; it begins with `why` there is no motion.
Truth truth_by_agreement(const Model& model, const State& start, double horizon, double most_seconds,
                         const std::string& why);

}  // namespace taut
