#pragma once

#include <nlohmann/json.hpp>

#include "base/failure.h"

namespace taut {

/// What is wrong with a request as JSON: an array of objects, for a scene one an error with file, line and
/// column (null where there is no such place), key, message and hint.
nlohmann::ordered_json bad_request_to_json(const BadRequest& problem);

}  // namespace taut
