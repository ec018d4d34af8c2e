#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "frames/stage_times.h"

namespace taut {

/// Seconds of a processor by stage, for machines.
nlohmann::ordered_json stages_to_json(const StageSeconds& stages);

/// What each stage took for each of so many frames, in a line.
std::string stages_text(const StageSeconds& stages, std::size_t frames);

}  // namespace taut
