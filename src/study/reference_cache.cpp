#include "study/reference_cache.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "host/versions.h"
#include "json_cache.h"
#include "methods/registry.h"
#include "states_json.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

std::string key_of(const Scene& scene, const std::vector<double>& times, double accuracy,
                   double most_seconds) {
  Hash hash;
  hash.add(physics_toml(scene))
      .add(physics_version())
      .add(judging_version())
      .add(std::span<const double>(times));
  return hash.add(std::span(&accuracy, 1)).add(std::span(&most_seconds, 1)).hex();
}

Json reference_to_json(const Reference& reference) {
  return {{"states", states_to_json(reference.states)},
          {"uncertainty", reference.uncertainty},
          {"certified_until", reference.certified_until},
          {"how", reference.how},
          {"refusal", reference.refusal}};
}

Reference reference_from_json(const Json& json, const State& start) {
  Reference reference;
  reference.states = states_from_json(json.at("states"), start);
  json.at("uncertainty").get_to(reference.uncertainty);
  json.at("certified_until").get_to(reference.certified_until);
  json.at("how").get_to(reference.how);
  json.at("refusal").get_to(reference.refusal);
  return reference;
}

}  // namespace

std::string physics_toml(const Scene& scene) {
  Scene physics;
  physics.title = scene.title;
  physics.duration = scene.duration;
  physics.settings = complete_settings({"rattle", {}});
  physics.description = scene.description;
  return resolved_toml(physics);
}

std::filesystem::path reference_folder() {
  if (const char* folder = std::getenv("TAUT_CACHE"); folder != nullptr && *folder != '\0') return folder;
  if (const char* caches = std::getenv("XDG_CACHE_HOME"); caches != nullptr && *caches != '\0')
    return std::filesystem::path(caches) / "taut";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return std::filesystem::path(home) / ".cache" / "taut";
  return std::filesystem::temp_directory_path() / "taut";
}

Reference cached_reference(const Scene& scene, const std::vector<double>& times, double accuracy,
                           const std::filesystem::path& folder, double most_seconds, const StopTest& stop) {
  return cached(
      folder / (key_of(scene, times, accuracy, most_seconds) + ".json"),
      [&] { return make_reference(scene.model, scene.start, times, accuracy, most_seconds, stop); },
      reference_to_json, [&](const Json& json) { return reference_from_json(json, scene.start); });
}

}  // namespace taut
