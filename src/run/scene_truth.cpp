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
#include "measure/events.h"
#include "measure/measures.h"
#include "run/build_info.h"
#include "states_json.h"

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

// The reference that reaches furthest into the horizon, or into an eighth of it; then, as far as that
// reaches, the tightest.
Reference longest_reference(const Scene& scene, double horizon, double finest,
                            const std::filesystem::path& folder) {
  constexpr double loose = 1e-6, worth = 1.5;
  const double size = scene_size(scene.model, scene.start);
  Reference best;
  best.refusal = fmt::format("{} links are too many to certify their motion", scene.model.links.size());
  if (scene.model.links.size() > most_links) return best;
  for (const double until : {horizon, horizon / 8.0}) {
    best = cached_reference(scene, instants_until(until), loose * size, folder);
    if (best.certified()) break;
  }
  if (!best.certified() || finest >= loose) return best;
  Reference tight = cached_reference(scene, instants_until(best.certified_until), finest * size, folder);
  return tight.certified() && worth * tight.certified_until >= best.certified_until ? tight : best;
}

Json summaries_to_json(const std::vector<Summary>& summaries) {
  Json json = Json::array();
  for (const Summary& summary : summaries) json.push_back({summary.sag, summary.energy, summary.strain});
  return json;
}

Json to_json(const Truth& truth) {
  return {{"times", truth.times},
          {"states", states_to_json(truth.states)},
          {"summaries", summaries_to_json(truth.summaries)},
          {"how", truth.how},
          {"remark", truth.remark},
          {"smallest", errors_to_json(truth.smallest)}};
}

Truth from_json(const Json& json, const State& start) {
  Truth truth;
  json.at("times").get_to(truth.times);
  truth.states = states_from_json(json.at("states"), start);
  for (const Json& entry : json.at("summaries"))
    truth.summaries.push_back(
        {entry.at(0).get<double>(), entry.at(1).get<double>(), entry.at(2).get<double>()});
  json.at("how").get_to(truth.how);
  json.at("remark").get_to(truth.remark);
  truth.smallest = errors_from_json(json.at("smallest"));
  return truth;
}

// How long a motion has to be agreed on to be of use, of the time that is free of events.
constexpr double enough = 0.25;

// The motion that two methods agree on, events and all, up to a horizon or an eighth of it.
std::optional<Truth> motion_by_agreement(const Scene& scene, double horizon, double calm_until,
                                         double most_seconds) {
  for (const double until : {horizon, horizon / 8.0}) {
    if (until < enough * calm_until) break;
    const std::vector<Opinion> opinions =
        opinions_of(scene.model, scene.start, instants_until(until), most_seconds);
    // Until the first event more methods have a say.
    if (calm_until < horizon && one_method_alone(opinions)) break;
    auto truth = agreed_motion(scene.model, scene.start, opinions);
    if (truth && truth->horizon() >= enough * calm_until) return truth;
  }
  return std::nullopt;
}

Truth summaries_by_agreement(const Scene& scene, double horizon, double most_seconds,
                             const std::string& why) {
  const Model calm = without_events(scene.model);
  const std::vector<double> times = instants_until(horizon);
  return agreed_summaries(calm, scene.start, opinions_of(calm, scene.start, times, most_seconds), times, why);
}

// How far into the horizon the truth was wanted, and how far it goes.
std::string cut_remark(double reached, double wanted, const std::string& why) {
  return fmt::format("looked at until {:.3g} s of {:.3g} s: {}", reached, wanted, why);
}

Truth truth_by_agreement(const Scene& scene, const TruthRequest& request, double calm_until, double wanted,
                         const std::string& why) {
  if (request.motion)
    if (auto truth = motion_by_agreement(scene, wanted, calm_until, request.most_seconds)) {
      if (truth->horizon() < wanted)
        truth->remark = cut_remark(truth->horizon(), wanted, "beyond that no two methods agree");
      return *std::move(truth);
    }
  return summaries_by_agreement(scene, calm_until, request.most_seconds, why);
}

// The same, kept in a file.
Truth cached_agreement(const Scene& scene, const TruthRequest& request, double calm_until, double wanted,
                       const std::string& why, const std::filesystem::path& folder) {
  const std::array numbers{calm_until, wanted, request.most_seconds, request.motion ? 1.0 : 0.0};
  const std::string key =
      Hash().add(physics_toml(scene)).add(build_info()).add(why).add(std::span<const double>(numbers)).hex();
  return cached(
      folder / (key + ".agreement.json"),
      [&] { return truth_by_agreement(scene, request, calm_until, wanted, why); }, to_json,
      [&](const Json& json) { return from_json(json, scene.start); });
}

}  // namespace

Truth scene_truth(const Scene& scene, const TruthRequest& request, const std::filesystem::path& folder) {
  constexpr double worth = 2.0;
  const double wanted = sixtieths(std::min(request.horizon.value_or(scene.duration), scene.duration));
  const std::optional<Event> event = first_event(scene.model, scene.start, wanted);
  const double calm_until = event ? std::max(1.0, std::floor(60.0 * time_before(*event))) / 60.0 : wanted;
  const std::string ending = event ? fmt::format("at {:.3g} s {}", event->time, event->what) : "";
  if (!request.motion)
    return cached_agreement(scene, request, calm_until, wanted, "no motion was asked for", folder);

  const Reference reference = longest_reference(scene, calm_until, request.finest, folder);
  if (!reference.certified()) {
    const std::string why = "no motion: " + reference.refusal + (event ? "; " + ending : "");
    return cached_agreement(scene, request, calm_until, wanted, why, folder);
  }
  Truth truth = truth_from(scene.model, scene.start, reference);
  if (truth.horizon() < wanted)
    truth.remark = cut_remark(truth.horizon(), wanted,
                              event ? ending : std::string("beyond that no motion could be certified"));
  if (!event || worth * truth.horizon() >= wanted) return truth;
  Truth agreed = cached_agreement(scene, request, calm_until, wanted, "", folder);
  return !agreed.states.empty() && agreed.horizon() > worth * truth.horizon() ? agreed : truth;
}

}  // namespace taut
