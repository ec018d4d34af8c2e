#pragma once

#include <nlohmann/json.hpp>

#include "frames/certifier.h"
#include "motion/run_measures.h"
#include "scene/scene.h"

namespace taut {

/// What was measured of a scene's run, for machines; every number is SI, and null where its method does not
/// know it.
nlohmann::ordered_json measures_to_json(const RunMeasures& measures, const Scene& scene);

/// What a second run says of a first.
nlohmann::ordered_json certificate_to_json(const Certificate& certificate);

}  // namespace taut
