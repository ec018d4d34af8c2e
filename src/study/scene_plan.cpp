#include "study/scene_plan.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "host/versions.h"
#include "json_cache.h"
#include "measure/quick_plan.h"
#include "study/scene_truth.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

// Shares of the time: for finding out what is true; what one run may cost that this is made of, of which
// there are a dozen; and what the short runs by rule may cost, predicted, where no truth was found.
constexpr double share_for_truth = 0.6, share_of_certificate = 0.08, share_of_agreement = 0.03,
                 share_without_truth = 0.15;

class Deadline {
  using Clock = std::chrono::steady_clock;

 public:
  explicit Deadline(double seconds) : end_(Clock::now() + std::chrono::duration<double>(seconds)) {}
  bool passed() const { return Clock::now() >= end_; }

 private:
  std::chrono::time_point<Clock, std::chrono::duration<double>> end_;
};

Json plan_to_json(const Plan& plan) {
  Json values = Json::object();
  for (const auto& [name, value] : plan.settings.values)
    std::visit([&, &key = name](const auto& held) { values[key] = held; }, value);
  return {{"method", plan.settings.method},
          {"values", values},
          {"reached", plan.reached},
          {"kind", name_of(plan.kind)},
          {"wanted", plan.wanted},
          {"estimated_error", plan.estimated_error ? Json(*plan.estimated_error) : Json()},
          {"judged_until", plan.judged_until},
          {"duration", plan.duration},
          {"size", plan.size},
          {"predicted_seconds", plan.predicted_seconds},
          {"runs", plan.runs},
          {"why", plan.why},
          {"reasons", plan.reasons}};
}

Plan plan_from_json(const Json& json) {
  Plan plan;
  plan.searched = true;
  json.at("method").get_to(plan.settings.method);
  for (const auto& [name, value] : json.at("values").items())
    if (value.is_string())
      plan.settings.values[name] = value.get<std::string>();
    else
      plan.settings.values[name] = value.get<double>();
  json.at("reached").get_to(plan.reached);
  for (const ErrorKind kind : all_error_kinds)
    if (name_of(kind) == json.at("kind").get<std::string>()) plan.kind = kind;
  json.at("wanted").get_to(plan.wanted);
  if (!json.at("estimated_error").is_null()) plan.estimated_error = json.at("estimated_error").get<double>();
  json.at("judged_until").get_to(plan.judged_until);
  json.at("duration").get_to(plan.duration);
  json.at("size").get_to(plan.size);
  json.at("predicted_seconds").get_to(plan.predicted_seconds);
  json.at("runs").get_to(plan.runs);
  json.at("why").get_to(plan.why);
  json.at("reasons").get_to(plan.reasons);
  return plan;
}

TruthRequest truth_request(const Scene& scene, const PlanSearch& search, StopTest stop) {
  TruthRequest request;
  request.judged = wanted_error(search.target, scene.model, scene.start);
  request.certify_seconds = share_of_certificate * search.seconds;
  request.agree_seconds = share_of_agreement * search.seconds;
  request.stop = std::move(stop);
  return request;
}

// Nothing where it is not found in time.
std::optional<Truth> truth_in_time(const Scene& scene, const PlanSearch& search,
                                   const std::filesystem::path& folder) {
  const Deadline deadline(share_for_truth * search.seconds);
  const StopTest stop = [&] { return deadline.passed() || (search.stop && search.stop()); };
  try {
    return scene_truth(scene, truth_request(scene, search, stop), folder);
  } catch (const Interrupted&) {
    stop_if_told(search.stop);
    return std::nullopt;
  }
}

// By rule, with what is left of the time.
Plan plan_without_truth(const Scene& scene, const PlanSearch& search, const Deadline& deadline, Plan plan) {
  try {
    plan = quick_plan(
        scene.model, scene.start, scene.duration, search.target, search.only,
        [&] { return deadline.passed() || (search.stop && search.stop()); },
        share_without_truth * search.seconds);
  } catch (const Interrupted&) {
    stop_if_told(search.stop);
  }
  plan.searched = true;
  plan.why += "; by rule, because what is true of this scene was not found in time";
  return plan;
}

Plan searched_plan(const Scene& scene, const PlanSearch& search, const std::filesystem::path& folder) {
  const Deadline deadline(search.seconds);
  Plan first = quick_plan(scene.model, scene.start, scene.duration, search.target, search.only, search.stop);
  const std::optional<Truth> truth = truth_in_time(scene, search, folder);
  if (!truth) return plan_without_truth(scene, search, deadline, std::move(first));
  return make_plan(scene.model, scene.start, *truth, search.target, first,
                   {search.only, [&] { return deadline.passed(); }, search.stop});
}

}  // namespace

Plan plan_scene(const Scene& scene, const PlanSearch& search, const std::filesystem::path& folder) {
  const std::array numbers{search.target.error, search.target.metres ? 1.0 : 0.0, search.seconds};
  const std::string key = Hash()
                              .add(physics_toml(scene))
                              .add(physics_version())
                              .add(judging_version())
                              .add(std::string(name_of(search.target.kind)))
                              .add(std::string(search.only))
                              .add(std::span<const double>(numbers))
                              .hex();
  return cached(
      folder / (key + ".plan.json"), [&] { return searched_plan(scene, search, folder); }, plan_to_json,
      plan_from_json);
}

Truth truth_for_plan(const Scene& scene, const PlanSearch& search, const std::filesystem::path& folder) {
  return scene_truth(scene, truth_request(scene, search, search.stop), folder);
}

}  // namespace taut
