#pragma once

#include <vector>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Every whole link that is over a threshold of its own: longer than break_stretch × its length, or pulling
/// harder than break_tension. break_stretch is left to a method that tests it within its steps, but for links
/// between two pins.
std::vector<Index> links_over_threshold(const Model& model, const Capabilities& can, const State& state);

}  // namespace taut
