#pragma once

#include <cstdint>
#include <string_view>

#include "methods/method.h"
#include "model/model.h"
#include "motion/run.h"

namespace taut {

/// What a run costs, in seconds of one core of an ordinary machine, from counts alone, so that whatever is
/// decided by it is decided alike everywhere. A price a step, one a round, one a link and step, a price a
/// link corrected or row of a direct solve, which is another in nets, and there one a factorisation and
/// rows^1.5 (the growth of a sparse factorisation of a net with a good order); where limits on angles make
/// direct solves dense, one a round and rows³; limits and contact points have prices of their own. The prices
/// of each method are fitted to chains of 20 to 10,000 links and nets of 10 × 10 to 64 × 64 masses, and
/// mostly within a factor of two of them (tests/bench/prices_bench.cpp).
double predicted_seconds(const Model& model, std::string_view method, const StepReport& counts, double steps);

/// What a run has cost so far.
double predicted_seconds(const Model& model, const Run& run);

/// The same before anything has run: so many steps, with so many passes, or rounds of a direct solve, each.
double predicted_seconds(const Model& model, std::string_view method, double steps, std::int64_t passes);

/// The same for so many seconds of a scene with complete settings, at their pace (pace.h); two rounds a step
/// where the method makes no passes.
double predicted_seconds(const Model& model, const Settings& settings, double seconds);

}  // namespace taut
