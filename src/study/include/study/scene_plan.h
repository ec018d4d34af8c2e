#pragma once

#include <filesystem>
#include <string_view>

#include "base/stop.h"
#include "measure/planner.h"
#include "scene/scene.h"
#include "study/reference_cache.h"

namespace taut {

/// A search for a plan, in words of the clock.
struct PlanSearch {
  AccuracyTarget target;
  std::string_view only;  ///< a method that the plan has to use; empty: any
  double seconds = 20.0;  ///< after which the best so far is taken
  StopTest stop = {};     ///< asked all the time; ends it with Interrupted
};

/// Plans a scene's run within a stated time: a first plan by rule (quick_plan()); then, for at most six
/// tenths of the time, what is true of the scene (scene_truth()); then the search (make_plan()). Where no
/// truth is found in time the plan by rule is taken, and says so. Kept in a folder, as truths are, so that
/// the same command goes the same way again. Throws BadRequest where no method can do the scene, and
/// Interrupted.
Plan plan_scene(const Scene& scene, const PlanSearch& search,
                const std::filesystem::path& folder = reference_folder());

/// What a search for such a plan takes for true where time does not matter: scene_truth(), as far as errors
/// of the target's size need it. Throws Interrupted.
Truth truth_for_plan(const Scene& scene, const PlanSearch& search,
                     const std::filesystem::path& folder = reference_folder());

}  // namespace taut
