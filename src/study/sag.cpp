#include "study/sag.h"

#include <fmt/format.h>

#include "base/failure.h"
#include "methods/registry.h"
#include "model/measures.h"

namespace taut {
namespace {

SagEntry compare(const Scene& scene, const SagStudy& study, int passes, RestShape shape) {
  SagEntry entry;
  entry.passes = passes;
  entry.sag = sag(scene.model, shape.state);
  entry.sag_error = entry.sag - study.exact_sag;
  entry.position_error = position_error(shape.state, study.exact.state);
  entry.largest_strain = link_strain(scene.model, shape.state).largest;
  entry.shape = std::move(shape);
  return entry;
}

// The text's own scheme at the scene's end: gravity has added speed all the while.
SagEntry growing_entry(const Scene& scene, const SagStudy& study, int passes, const StopTest& stop) {
  Scene kept = scene;
  kept.settings.values["velocities"] = "kept";
  kept.settings.values["passes"] = static_cast<double>(passes);
  RestShape moment;
  Simulation simulation(kept);
  const std::optional<State> end = simulation.at(kept.duration, stop);
  if (!end) throw Interrupted();
  moment.state = *end;
  moment.how = "euler, velocities kept";
  SagEntry entry = compare(scene, study, passes, std::move(moment));
  entry.growing = true;
  return entry;
}

}  // namespace

std::optional<SagStudy> study_sag(const Scene& scene, const std::vector<int>& passes,
                                  const std::function<void(int)>& done, const StopTest& stop) {
  const Method& method = *find_method(scene.settings.method);
  if (find_param(method, "passes") == nullptr)
    throw BadRequest(fmt::format(
        "method \"{}\" makes no passes over its links; those that do are euler, verlet, xpbd and shake",
        method.name));
  const bool euler = method.name == "euler";
  const Settling settling;
  SagStudy study;
  study.settings = scene.settings;
  if (euler) study.settings.values["velocities"] = "derived";
  study.exact = exact_rest_shape(scene.model, scene.start, settling, stop);
  study.exact_sag = sag(scene.model, study.exact.state);
  for (const int count : passes) {
    Settings settings = study.settings;
    settings.values["passes"] = static_cast<double>(count);
    study.entries.push_back(
        compare(scene, study, count, settle(scene.model, scene.start, settings, settling, stop)));
    if (stop && stop()) return std::nullopt;
    done(static_cast<int>(study.entries.size()));
  }
  if (euler) study.entries.push_back(growing_entry(scene, study, passes.back(), stop));
  return study;
}

}  // namespace taut
