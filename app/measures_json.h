#pragma once

#include <nlohmann/json.hpp>

#include "model/model.h"
#include "motion/run_measures.h"

namespace taut {

/// What was measured of a run, for machines; every number is SI.
nlohmann::ordered_json measures_to_json(const RunMeasures& measures, const Model& model);

}  // namespace taut
