#pragma once

#include <cstdint>

#include "motion/advance.h"
#include "methods/method.h"

namespace taut {

/// Makes `steps` steps of 1/steps_per_second from a start, the time after step n being n/steps_per_second
/// exactly (counted from the start's time). Ends early, with the failed step's status, where a step can't be
/// solved; `state` is then the last good one. The report's counts are sums over all steps.
StepReport simulate(const Model& model, State& state, const Settings& settings, std::int64_t steps,
                    const Guard& guard = {});

}  // namespace taut
