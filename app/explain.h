#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "measure/plan.h"
#include "study/explain.h"

namespace taut {

/// An explanation as JSON: what is modelled, what is left out, and seconds a step.
nlohmann::ordered_json explanation_to_json(const Explanation& explanation);

/// The same for people: indented lines, to stand below the one that names the scene.
std::string explanation_text(const Scene& scene, const Explanation& explanation);

/// How a plan was come to, a line a reason.
std::string reasons_text(const Plan& plan);

}  // namespace taut
