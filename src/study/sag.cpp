#include "study/sag.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <variant>

#include "base/failure.h"
#include "base/hash.h"
#include "host/build_info.h"
#include "json_cache.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "states_json.h"
#include "study/reference_cache.h"

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

// The shape that `make` gives, kept in a file: the same asked again of the same build is only read. A state
// with broken links could not be read again.
RestShape kept_shape(const Scene& scene, const Settings& settings, std::string_view what,
                     const StopTest& stop, const std::function<RestShape()>& make) {
  Hash hash;
  hash.add(physics_toml(scene)).add(build_info()).add(what).add(settings.method);
  for (const auto& [name, value] : settings.values) {
    hash.add(name);
    std::visit([&](const auto& plain) { hash.add(fmt::format("{}", plain)); }, value);
  }
  const std::filesystem::path file = reference_folder() / fmt::format("sag-{}.json", hash.hex());
  const auto made = [&] {
    RestShape shape = make();
    stop_if_told(stop);
    return shape;
  };
  if (!scene.model.breakable_links.empty()) return made();
  return cached(
      file, made,
      [](const RestShape& shape) {
        return nlohmann::ordered_json{{"state", states_to_json({shape.state})},
                                      {"largest_movement", shape.largest_movement},
                                      {"at_rest", shape.at_rest},
                                      {"how", shape.how}};
      },
      [&](const nlohmann::ordered_json& json) {
        RestShape shape;
        shape.state = states_from_json(json.at("state"), scene.start).at(0);
        json.at("largest_movement").get_to(shape.largest_movement);
        json.at("at_rest").get_to(shape.at_rest);
        json.at("how").get_to(shape.how);
        return shape;
      });
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

SagStudy study_sag(const Scene& scene, const std::vector<int>& passes, const std::function<void(int)>& done,
                   const StopTest& stop) {
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
  study.exact = kept_shape(scene, {"newton", {}}, "exact", stop,
                           [&] { return exact_rest_shape(scene.model, scene.start, settling, stop); });
  study.exact_sag = sag(scene.model, study.exact.state);
  for (const int count : passes) {
    Settings settings = study.settings;
    settings.values["passes"] = static_cast<double>(count);
    study.entries.push_back(compare(scene, study, count, kept_shape(scene, settings, "settled", stop, [&] {
                                      return settle(scene.model, scene.start, settings, settling, stop);
                                    })));
    done(static_cast<int>(study.entries.size()));
  }
  if (euler) study.entries.push_back(growing_entry(scene, study, passes.back(), stop));
  return study;
}

}  // namespace taut
