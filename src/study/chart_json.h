#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "study/chart.h"

namespace taut {

/// A case as it is saved and shown.
nlohmann::ordered_json case_to_json(const ChartCase& done);
ChartCase case_from_json(const std::string& text, const GridPoint& point);

}  // namespace taut
