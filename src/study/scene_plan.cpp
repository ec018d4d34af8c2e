#include "study/scene_plan.h"

#include "study/scene_truth.h"

namespace taut {

Plan plan_scene(const Scene& scene, const AccuracyTarget& target, std::string_view only,
                const std::filesystem::path& folder, const StopTest& stop) {
  TruthRequest request;
  request.stop = stop;
  return make_plan(scene.model, scene.start, scene_truth(scene, request, folder), scene.duration, target,
                   only, stop);
}

}  // namespace taut
