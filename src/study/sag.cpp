#include "study/sag.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <variant>

#include "base/failure.h"
#include "base/hash.h"
#include "base/json_text.h"
#include "host/versions.h"
#include "json_cache.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "shard_files.h"
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

std::string shape_key(const Scene& scene, const Settings& settings, std::string_view what) {
  Hash hash;
  hash.add(physics_toml(scene)).add(physics_version()).add(judging_version()).add(what).add(settings.method);
  for (const auto& [name, value] : settings.values) {
    hash.add(name);
    std::visit([&](const auto& plain) { hash.add(fmt::format("{}", plain)); }, value);
  }
  return hash.hex();
}

nlohmann::ordered_json shape_to_json(const RestShape& shape) {
  return {{"state", states_to_json({shape.state})},
          {"largest_movement", shape.largest_movement},
          {"at_rest", shape.at_rest},
          {"how", shape.how}};
}

RestShape shape_from_json(const nlohmann::ordered_json& json, const State& start) {
  RestShape shape;
  shape.state = states_from_json(json.at("state"), start).at(0);
  json.at("largest_movement").get_to(shape.largest_movement);
  json.at("at_rest").get_to(shape.at_rest);
  json.at("how").get_to(shape.how);
  return shape;
}

// Shapes that are kept: among the cases of the study's folder, for shards and for whoever goes on, and in the
// cache, for studies in other folders.
class Shapes {
 public:
  Shapes(const Scene& scene, const SagRequest& request, const StopTest& stop)
      : scene_(scene),
        stop_(stop),
        shard_(request.shard),
        file_(request.folder / "shapes.jsonl"),
        known_(read_cases(shard_file(file_, shard_), physics_version())) {
    if (shard_.all())
      for (const std::filesystem::path& file : shard_files(file_))
        known_.merge(read_cases(file, physics_version()));
  }

  RestShape get(const Settings& settings, std::string_view what, const std::function<RestShape()>& make) {
    const auto made = [&] {
      RestShape shape = make();
      stop_if_told(stop_);
      return shape;
    };
    // A state with broken links could not be read again.
    if (!scene_.model.breakable_links.empty()) return made();
    const std::string key = shape_key(scene_, settings, what);
    const auto from_json = [&](const nlohmann::ordered_json& json) {
      return shape_from_json(json, scene_.start);
    };
    if (!known_.contains(key)) {
      const RestShape shape =
          cached(reference_folder() / fmt::format("sag-{}.json", key), made, shape_to_json, from_json);
      known_[key] = json_text(shape_to_json(shape));
      store().add(key, known_[key]);
    }
    return from_json(nlohmann::ordered_json::parse(known_[key]));
  }
  void finish() {
    if (!shard_.all()) mark_end(store(), shard_);
  }

 private:
  // Not before there is something to keep: a study that is refused leaves nothing behind.
  CaseStore& store() {
    if (!store_) store_.emplace(shard_file(file_, shard_), physics_version(), false);
    return *store_;
  }

  const Scene& scene_;
  const StopTest& stop_;
  Shard shard_;
  std::filesystem::path file_;
  std::map<std::string, std::string, std::less<>> known_;
  std::optional<CaseStore> store_;
};

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

void check_sag(const Scene& scene) {
  const Method& method = *find_method(scene.settings.method);
  if (find_param(method, "passes") == nullptr)
    throw BadRequest(fmt::format(
        "method \"{}\" makes no passes over its links; those that do are euler, verlet, xpbd and shake",
        method.name));
}

SagStudy study_sag(const Scene& scene, const SagRequest& request, const std::function<void(int)>& done,
                   const StopTest& stop) {
  check_sag(scene);
  const bool euler = scene.settings.method == "euler";
  const Settling settling;
  SagStudy study;
  study.settings = scene.settings;
  if (euler) study.settings.values["velocities"] = "derived";
  Shapes shapes(scene, request, stop);
  study.exact = shapes.get({"newton", {}}, "exact",
                           [&] { return exact_rest_shape(scene.model, scene.start, settling, stop); });
  study.exact_sag = sag(scene.model, study.exact.state);
  for (std::size_t i = 0; i < request.passes.size(); ++i) {
    if (!request.shard.has(i)) continue;
    const int count = request.passes[i];
    Settings settings = study.settings;
    settings.values["passes"] = static_cast<double>(count);
    study.entries.push_back(compare(scene, study, count, shapes.get(settings, "settled", [&] {
      return settle(scene.model, scene.start, settings, settling, stop);
    })));
    done(static_cast<int>(study.entries.size()));
  }
  shapes.finish();
  if (euler && request.shard.all())
    study.entries.push_back(growing_entry(scene, study, request.passes.back(), stop));
  return study;
}

}  // namespace taut
