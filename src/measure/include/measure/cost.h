#pragma once

#include "methods/method.h"
#include "model/model.h"

namespace taut {

/// What a run costs, in seconds of one core of an ordinary machine, from counts alone, so that whatever is
/// decided by it is decided alike everywhere: 15 ns a link corrected or row of a direct solve (at least once
/// a link and step), and 4 ns · rows^1.5 a factorisation (the growth of a sparse factorisation of a net with
/// a good order). Within a factor of about two of what is measured (docs/charts.md).
double predicted_seconds(const Model& model, const StepReport& counts, double steps);

}  // namespace taut
