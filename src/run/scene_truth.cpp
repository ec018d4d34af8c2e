#include "run/scene_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/hash.h"
#include "errors_json.h"
#include "json_cache.h"
#include "measure/agreement.h"
#include "measure/measures.h"
#include "run/build_info.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_links = 3000;  // more take minutes to certify, if they can be at all
constexpr int instants = 16;

double sixtieths(double time) {
  return std::max(1.0, std::round(time * 60.0)) / 60.0;
}

std::vector<double> instants_until(double horizon) {
  std::vector<double> times;
  for (int i = 1; i <= instants; ++i) {
    const double time = sixtieths(horizon * i / instants);
    if (times.empty() || time > times.back()) times.push_back(time);
  }
  return times;
}

// The reference that reaches furthest: the tightest of several accuracies, then of shorter horizons.
Reference longest_reference(const Scene& scene, double horizon, const std::filesystem::path& folder) {
  const double size = scene_size(scene.model, scene.start);
  Reference best;
  best.refusal = fmt::format("{} links are too many to certify their motion", scene.model.links.size());
  if (scene.model.links.size() > most_links) return best;
  for (const double until : {horizon, horizon / 8.0}) {
    for (const double accuracy : {1e-8, 1e-6}) {
      Reference reference = cached_reference(scene, instants_until(until), accuracy * size, folder);
      const bool further = reference.certified() && reference.certified_until > 1.5 * best.certified_until;
      if (further || !best.certified()) best = std::move(reference);
    }
    if (best.certified()) break;
  }
  return best;
}

Json to_json(const Truth& truth) {
  return {{"times", truth.times},
          {"sag", truth.sag},
          {"energy", truth.energy},
          {"strain", truth.strain},
          {"how", truth.how},
          {"remark", truth.remark},
          {"smallest", errors_to_json(truth.smallest)}};
}

Truth from_json(const Json& json) {
  Truth truth;
  json.at("times").get_to(truth.times);
  json.at("sag").get_to(truth.sag);
  json.at("energy").get_to(truth.energy);
  json.at("strain").get_to(truth.strain);
  json.at("how").get_to(truth.how);
  json.at("remark").get_to(truth.remark);
  truth.smallest = errors_from_json(json.at("smallest"));
  return truth;
}

// truth_by_agreement(), kept in a file.
Truth cached_agreement(const Scene& scene, double horizon, double most_seconds, const std::string& why,
                       const std::filesystem::path& folder) {
  const std::array numbers{horizon, most_seconds};
  const std::string key =
      Hash().add(physics_toml(scene)).add(build_info()).add(why).add(std::span<const double>(numbers)).hex();
  return cached(
      folder / (key + ".agreement.json"),
      [&] { return truth_by_agreement(scene.model, scene.start, horizon, most_seconds, why); }, to_json,
      from_json);
}

}  // namespace

Truth scene_truth(const Scene& scene, const TruthRequest& request, const std::filesystem::path& folder) {
  const double horizon = sixtieths(std::min(request.horizon.value_or(scene.duration), scene.duration));
  std::string why = "the end alone was asked for";
  if (request.motion) {
    const Reference reference = longest_reference(scene, horizon, folder);
    if (reference.certified()) {
      Truth truth = truth_from(scene.model, scene.start, reference);
      if (reference.certified_until < horizon)
        truth.remark =
            fmt::format("looked at until {:.3g} s of {:.3g} s: beyond that no motion could be certified",
                        reference.certified_until, horizon);
      return truth;
    }
    why = "no motion: " + reference.refusal;
  }
  return cached_agreement(scene, horizon, request.most_seconds, why, folder);
}

}  // namespace taut
