#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "command_line.h"
#include "measure/planner.h"
#include "scene/scene.h"

namespace taut {

/// Adds the flag --accuracy.
void add_accuracy(Verb& verb, std::string& accuracy);

/// Where an accuracy is given, or the scene leaves its method open, plans how to run the scene, puts that
/// into it, and says so on stderr. `method`: what --method says; the plan keeps to it. Throws BadRequest for
/// a text that is no accuracy.
std::optional<Plan> settle_method(Scene& scene, const std::string& accuracy, const std::string& method,
                                  bool quiet);

/// A plan for machines.
nlohmann::ordered_json plan_to_json(const Plan& plan);

/// After the run: how accurate it is estimated to be, on stderr.
void print_accuracy(const Plan& plan);

}  // namespace taut
