#pragma once

#include <filesystem>
#include <string_view>

#include "measure/planner.h"
#include "scene/scene.h"
#include "study/reference_cache.h"

namespace taut {

/// Plans a scene's run (make_plan()) by its truth (scene_truth()), which is kept in a folder. Throws
/// Interrupted.
Plan plan_scene(const Scene& scene, const AccuracyTarget& target, std::string_view only = {},
                const std::filesystem::path& folder = reference_folder(), const StopTest& stop = {});

}  // namespace taut
