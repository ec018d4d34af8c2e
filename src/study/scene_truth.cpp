#include "study/scene_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/hash.h"
#include "errors_json.h"
#include "host/versions.h"
#include "json_cache.h"
#include "measure/agreement.h"
#include "measure/events.h"
#include "measure/method_variants.h"
#include "model/measures.h"
#include "states_json.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

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

// How far it is worth looking where a truth ends within the first quarter of its instants: until the next one
// of them, so that instants lie close enough to tell where it ends. Nothing where it reaches further.
std::optional<double> nearer_horizon(const std::vector<double>& times, std::size_t reached) {
  if (4 * reached >= times.size()) return std::nullopt;
  return times[reached];
}

// What errors can be judged down to is a hundred times what a certified motion may be off, and ten times what
// two opinions differ by (truth.h, agreement.h); so much of what has to be judged is still good enough.
constexpr double enough_for_all = 1e-6;  // of the size: a difference that needs no finer look
constexpr double margin = 0.9, certified_share = 0.01, agreed_share = 0.1;

// The reference that reaches furthest into the horizon; then, as far as that reaches, the tightest.
Reference longest_reference(const Scene& scene, double horizon, const TruthRequest& request,
                            const std::filesystem::path& folder) {
  constexpr double worth = 1.5;
  const double size = scene_size(scene.model, scene.start);
  const double loosest = request.judged ? margin * certified_share * *request.judged : request.loosest;
  Reference best;
  best.refusal = "nothing was looked at yet";
  for (std::optional<double> until = horizon; until;) {
    const std::vector<double> times = instants_until(*until);
    Reference found =
        cached_reference(scene, times, loosest * size, folder, request.certify_seconds, request.stop);
    if (!best.certified() || found.certified()) best = std::move(found);
    until = nearer_horizon(times, best.states.size());
    if (until && *until == times.back()) break;
  }
  if (!best.certified() || request.judged || scene.model.links.size() > large_scene) return best;
  const std::vector<double> times = instants_until(best.certified_until);
  for (const double accuracy :
       {request.finest, 10.0 * request.finest, std::sqrt(request.finest * request.loosest)}) {
    Reference tight =
        cached_reference(scene, times, accuracy * size, folder, request.certify_seconds, request.stop);
    if (tight.certified() && worth * tight.certified_until >= best.certified_until) return tight;
  }
  return best;
}

Json summaries_to_json(const std::vector<Summary>& summaries) {
  Json json = Json::array();
  for (const Summary& summary : summaries) json.push_back({summary.sag, summary.energy, summary.strain});
  return json;
}

Json truth_to_json(const Truth& truth) {
  return {{"times", truth.times},
          {"states", states_to_json(truth.states)},
          {"summaries", summaries_to_json(truth.summaries)},
          {"how", truth.how},
          {"remark", truth.remark},
          {"smallest", errors_to_json(truth.smallest)}};
}

Truth truth_from_json(const Json& json, const State& start) {
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
constexpr double share_worth_having = 0.25;

bool one_method_alone(const Model& model, const State& start) {
  const std::vector<MethodVariant> curves = variants_of(model, start).variants;
  return std::ranges::all_of(curves,
                             [&](const MethodVariant& curve) { return curve.method == curves[0].method; });
}

// The motion that two methods agree on, events and all, as finely as they do over a time of some use: first,
// with little work, how far that is.
std::optional<Truth> motion_by_agreement(const Scene& scene, double horizon, double calm_until,
                                         const TruthRequest& request) {
  constexpr double little = 0.2;
  const double finer = request.judged ? 0.1 : 0.0;  // of the bound, where errors need not be told any finer
  // Until the first event more methods have a say.
  if (calm_until < horizon && one_method_alone(scene.model, scene.start)) return std::nullopt;
  const std::vector<double> bounds =
      request.judged ? std::vector{margin * agreed_share * *request.judged} : std::vector{1e-4, 1e-3, 1e-2};
  for (const double bound : bounds) {
    const auto look = [&](const std::vector<double>& times, double most_seconds) {
      return agreed_motion(scene.model, scene.start,
                           opinions_of(scene.model, scene.start, times, most_seconds,
                                       std::max(enough_for_all, finer * bound), request.stop),
                           bound);
    };
    std::vector<double> times = instants_until(horizon);
    for (;;) {
      const std::optional<Truth> truth = look(times, little * request.agree_seconds);
      const std::optional<double> nearer = nearer_horizon(times, truth ? truth->times.size() : 0);
      if (!nearer || *nearer == times.back()) break;
      times = instants_until(*nearer);
    }
    if (times.back() < share_worth_having * calm_until) continue;
    std::optional<Truth> truth = look(times, request.agree_seconds);
    if (truth && truth->horizon() >= share_worth_having * calm_until) return truth;
  }
  return std::nullopt;
}

Truth summaries_by_agreement(const Scene& scene, double horizon, const TruthRequest& request,
                             const std::string& why) {
  const Model calm = without_unlocated_events(scene.model, scene.start);
  const std::vector<double> times = instants_until(horizon);
  return agreed_summaries(
      calm, scene.start,
      opinions_of(calm, scene.start, times, request.agree_seconds, enough_for_all, request.stop), times, why);
}

// How far into the horizon the truth was wanted, and how far it goes.
std::string cut_remark(double reached, double wanted, const std::string& why) {
  return fmt::format("looked at until {:.3g} s of {:.3g} s: {}", reached, wanted, why);
}

// How long a truth is wanted (s), and how much of that is free of events.
struct Spans {
  double wanted = 0.0, calm = 0.0;
};

// A file of the cache for what is agreed on, by the parts of its name.
std::filesystem::path agreement_file(const Scene& scene, const TruthRequest& request, const Spans& spans,
                                     const std::string& what, const std::filesystem::path& folder) {
  const std::array numbers{spans.wanted, spans.calm, request.agree_seconds, request.judged.value_or(0.0)};
  const std::string key = Hash()
                              .add(physics_toml(scene))
                              .add(physics_version())
                              .add(judging_version())
                              .add(what)
                              .add(std::span<const double>(numbers))
                              .hex();
  return folder / (key + ".agreement.json");
}

std::optional<Truth> cached_motion(const Scene& scene, const TruthRequest& request, const Spans& spans,
                                   const std::filesystem::path& folder) {
  auto truth = cached(
      agreement_file(scene, request, spans, "motion", folder),
      [&] { return motion_by_agreement(scene, spans.wanted, spans.calm, request); },
      [](const std::optional<Truth>& found) { return found ? truth_to_json(*found) : Json(); },
      [&](const Json& json) {
        return json.is_null() ? std::nullopt : std::optional(truth_from_json(json, scene.start));
      });
  if (truth && truth->horizon() < spans.wanted)
    truth->remark = cut_remark(truth->horizon(), spans.wanted, "beyond that no two methods agree");
  return truth;
}

Truth cached_summaries(const Scene& scene, const TruthRequest& request, const Spans& spans,
                       const std::string& why, const std::filesystem::path& folder) {
  return cached(
      agreement_file(scene, request, spans, why, folder),
      [&] { return summaries_by_agreement(scene, spans.calm, request, why); }, truth_to_json,
      [&](const Json& json) { return truth_from_json(json, scene.start); });
}

}  // namespace

Truth scene_truth(const Scene& scene, const TruthRequest& request, const std::filesystem::path& folder) {
  constexpr double worth = 1.2;
  Spans spans;
  spans.wanted = sixtieths(std::min(request.horizon.value_or(scene.duration), scene.duration));
  const std::optional<Event> event = first_event(scene.model, scene.start, spans.wanted, request.stop);
  spans.calm = event ? std::max(1.0, std::floor(60.0 * time_before(*event))) / 60.0 : spans.wanted;
  const std::string ending = event ? fmt::format("at {:.3g} s {}", event->time, event->what) : "";
  if (!request.motion) return cached_summaries(scene, request, spans, "no motion was asked for", folder);

  const Reference reference = longest_reference(scene, spans.calm, request, folder);
  std::optional<Truth> certified;
  if (reference.certified()) {
    certified = truth_from(scene.model, scene.start, reference);
    if (certified->horizon() < spans.wanted)
      certified->remark = cut_remark(certified->horizon(), spans.wanted,
                                     event ? ending : "beyond that no motion could be certified");
    if (certified->horizon() >= spans.wanted || !has_events(scene.model)) return *std::move(certified);
  }
  const std::optional<Truth> agreed = cached_motion(scene, request, spans, folder);
  if (agreed && (!certified || agreed->horizon() > worth * certified->horizon())) return *agreed;
  if (certified) return *std::move(certified);
  return cached_summaries(scene, request, spans,
                          "no motion: " + reference.refusal + (event ? "; " + ending : ""), folder);
}

}  // namespace taut
