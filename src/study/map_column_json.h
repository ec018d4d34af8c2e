#pragma once

#include <string>

#include "measure/stability_column.h"

namespace taut {

/// A column as compact JSON, and back. The reading throws nlohmann::json::exception for other text.
std::string map_column_to_json(const MapColumn& column);
MapColumn map_column_from_json(const std::string& text);

}  // namespace taut
