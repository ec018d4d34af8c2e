#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "model/state.h"
#include "motion/run_measures.h"
#include "view/expectation.h"

namespace taut {

/// One thing a scene expects, and whether it came true.
struct Finding {
  std::string key;  ///< the key of [expect]
  bool holds = false;
  std::string text;  ///< what was measured beside what was expected
};

/// Tests every part of an expectation that is stated, in the order of its members, on the end of a run and
/// what was measured of it.
std::vector<Finding> check_expectation(const Expectation& expectation, const Model& model, const State& end,
                                       const RunMeasures& measures);

}  // namespace taut
