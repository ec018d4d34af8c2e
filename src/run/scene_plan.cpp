#include "run/scene_plan.h"

#include <algorithm>

#include "measure/cost.h"
#include "run/scene_truth.h"

namespace taut {
namespace {

// Large scenes are looked at only as long as runs stay short, small ones as charts look at them.
TruthRequest request_for(const Scene& scene) {
  constexpr double longest_run = 0.25;  // s, predicted, of one pass at `fine` steps per second
  constexpr double fine = 960.0;
  TruthRequest request;
  if (scene.model.links.size() > large_scene)
    request.horizon = std::min(scene.duration, longest_run / predicted_seconds(scene.model, "xpbd", fine, 1));
  return request;
}

}  // namespace

Plan plan_scene(const Scene& scene, const AccuracyTarget& target, std::string_view only,
                const std::filesystem::path& folder, const StopTest& stop) {
  TruthRequest request = request_for(scene);
  request.stop = stop;
  return make_plan(scene.model, scene.start, scene_truth(scene, request, folder), scene.duration, target,
                   only, stop);
}

}  // namespace taut
