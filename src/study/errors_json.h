#pragma once

#include <nlohmann/json.hpp>

#include "measure/truth.h"

namespace taut {

/// Errors as JSON: a number for each kind there is, by its name.
nlohmann::ordered_json errors_to_json(const Errors& errors);
Errors errors_from_json(const nlohmann::ordered_json& json);

}  // namespace taut
