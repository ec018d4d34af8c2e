#include "run/scene_plan.h"

#include <algorithm>

#include "measure/cost.h"
#include "measure/measures.h"
#include "run/scene_truth.h"

namespace taut {
namespace {

constexpr double longest_run = 0.25;  // s, predicted, of one pass at `fine` steps per second
constexpr double fine = 960.0;
constexpr double opinion_seconds = 1.5;  // predicted, of one run where two methods have to agree

TruthRequest request_for(const Scene& scene, const AccuracyTarget& target) {
  constexpr double demanding = 1e-3;
  const double wanted = target.metres ? target.error / scene_size(scene.model, scene.start) : target.error;
  TruthRequest request;
  request.horizon = std::min(scene.duration, longest_run / predicted_seconds(scene.model, "xpbd", fine, 1));
  request.finest = wanted < demanding ? 1e-8 : 1e-6;
  request.most_seconds = opinion_seconds;
  return request;
}

}  // namespace

Plan plan_scene(const Scene& scene, const AccuracyTarget& target, std::string_view only,
                const std::filesystem::path& folder) {
  return make_plan(scene.model, scene.start, scene_truth(scene, request_for(scene, target), folder),
                   scene.duration, target, only);
}

}  // namespace taut
