#include "planning.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "study/scene_plan.h"

namespace taut {

void add_accuracy(Verb& verb, std::string& accuracy) {
  verb.add_option("--accuracy", accuracy,
                  "Choose method, step and passes, the cheapest that is this good: 1% (of the scene's size), "
                  "trajectory=1mm, strain=1e-3, sag=0.5%");
}

std::optional<Plan> settle_method(Scene& scene, const std::string& accuracy, const std::string& method,
                                  bool quiet) {
  if (accuracy.empty() && scene.solve_given) return std::nullopt;
  const std::string& text = accuracy.empty() ? scene.accuracy : accuracy;
  const std::optional<AccuracyTarget> target = parse_accuracy(text);
  if (!target)
    throw BadRequest(
        fmt::format("--accuracy is such as 1%, trajectory=1mm, strain=1e-3, energy=0.1% or sag=0.5%, not {}",
                    in_quotes(text)));
  if (!quiet) fmt::print(stderr, "taut: looking for the cheapest way to {} in {}\n", text, scene.name);
  Plan plan = plan_scene(scene, *target, method);
  scene.settings = plan.settings;
  scene.solve_given = true;
  if (!quiet) fmt::print(stderr, "taut: for {} in {}: {}\n", text, scene.name, plan.why);
  return plan;
}

nlohmann::ordered_json plan_to_json(const Plan& plan) {
  return {{"why", plan.why},
          {"reached", plan.reached},
          {"error_kind", name_of(plan.kind)},
          {"wanted", plan.wanted},
          {"estimated_error", plan.estimated_error},
          {"looked_until", plan.looked_until},
          {"predicted_seconds", plan.predicted_seconds}};
}

void print_accuracy(const Plan& plan) {
  fmt::print(stderr, "accuracy: {} error estimated at {:.2g}, over the first {:.3g} s; {:.2g} was wanted\n",
             name_of(plan.kind), plan.estimated_error, plan.looked_until, plan.wanted);
}

}  // namespace taut
