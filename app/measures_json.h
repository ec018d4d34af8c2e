#pragma once

#include <nlohmann/json.hpp>

#include "motion/run_measures.h"
#include "scene/scene.h"

namespace taut {

/// What was measured of a scene's run, for machines; every number is SI, and null where its method does not
/// know it.
nlohmann::ordered_json measures_to_json(const RunMeasures& measures, const Scene& scene);

}  // namespace taut
