#include "run/scene_plan.h"

#include <algorithm>

#include "measure/cost.h"
#include "run/scene_truth.h"

namespace taut {
namespace {

constexpr std::size_t large = 3000;   // links; scenes with fewer are looked at whole, as charts do
constexpr double longest_run = 0.25;  // s, predicted, of one pass at `fine` steps per second
constexpr double fine = 960.0;

// What is to be known of a scene for a target, by runs of so many seconds where two methods have to agree.
TruthRequest request_for(const Scene& scene, double wanted, double most_seconds) {
  constexpr double demanding = 1e-3;
  TruthRequest request;
  if (scene.model.links.size() > large)
    request.horizon = std::min(scene.duration, longest_run / predicted_seconds(scene.model, "xpbd", fine, 1));
  request.finest = wanted < demanding ? 1e-8 : 1e-6;
  request.most_seconds = most_seconds;
  return request;
}

// Large scenes are first looked at briefly, and longer where that is not enough to judge the target by.
Truth truth_for(const Scene& scene, const AccuracyTarget& target, double wanted,
                const std::filesystem::path& folder) {
  constexpr double brief = 1.5;
  const double full = TruthRequest{}.most_seconds;
  if (scene.model.links.size() > large) {
    Truth truth = scene_truth(scene, request_for(scene, wanted, brief), folder);
    const ErrorKind kind = judging_kind(truth, target.kind, wanted);
    if (truth.smallest[kind].value_or(infinity) <= wanted) return truth;
  }
  return scene_truth(scene, request_for(scene, wanted, full), folder);
}

}  // namespace

Plan plan_scene(const Scene& scene, const AccuracyTarget& target, std::string_view only,
                const std::filesystem::path& folder) {
  const double wanted = wanted_error(target, scene.model, scene.start);
  return make_plan(scene.model, scene.start, truth_for(scene, target, wanted, folder), scene.duration, target,
                   only);
}

}  // namespace taut
