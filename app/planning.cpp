#include "planning.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "estimate.h"
#include "host/progress.h"
#include "host/standard_streams.h"
#include "measure/quick_plan.h"
#include "study/scene_plan.h"
#include "values.h"

namespace taut {
namespace {

AccuracyTarget target_from(const std::string& text) {
  if (const std::optional<AccuracyTarget> target = parse_accuracy(text)) return *target;
  throw BadRequest(
      fmt::format("--accuracy is such as 1%, trajectory=1mm, strain=1e-3, energy=0.1% or sag=0.5%, not {}",
                  in_quotes(text)));
}

double search_seconds(const std::string& text) {
  constexpr double most = 86400.0;
  const double seconds = parse_seconds("--search", text);
  if (!(seconds > 0.0 && seconds <= most))
    throw BadRequest(fmt::format("--search is more than 0 s and at most {} s, not {} s", most, seconds));
  return seconds;
}

// Shows how much of the search's time is gone whenever the search asks whether to stop.
Plan searched(const Scene& scene, const PlanFlags& flags, const std::string& method, bool quiet,
              const StopTest& stop) {
  using Clock = std::chrono::steady_clock;
  PlanSearch search{target_from(flags.accuracy), method, search_seconds(flags.search), {}};
  if (!quiet)
    tell("taut: searching for the cheapest way to {} in {}, for at most {:.3g} s\n", flags.accuracy,
         scene.name, search.seconds);
  Progress progress(stderr, progress_style(stderr, quiet), "seconds of the search");
  progress.start(static_cast<int>(search.seconds));
  const Clock::time_point begin = Clock::now();
  search.stop = [&] {
    progress.show_spent(std::chrono::duration<double>(Clock::now() - begin).count());
    return stop && stop();
  };
  Plan plan = plan_scene(scene, search);
  progress.finish();
  return plan;
}

void say_run(const Scene& scene, bool quiet, double picture_bytes) {
  const std::string note = quiet ? std::string() : run_note(scene, picture_bytes);
  if (!note.empty()) tell("taut: {}: note: {}\n", scene.name, note);
}

}  // namespace

void PlanFlags::add_to(Verb& verb) {
  verb.add_option(
      "--accuracy", accuracy,
      "Search for method, step and passes, the cheapest that are this good: 1% (of the scene's size, "
      "the diagonal of the box around all masses at the start), trajectory=1mm, strain=1e-3, sag=0.5%");
  verb.add_option("--search", search, "How long --accuracy may search; then the best so far is taken")
      ->capture_default_str();
}

std::optional<Plan> settle_method(Scene& scene, const PlanFlags& flags, const std::string& method, bool quiet,
                                  const StopTest& stop, double picture_bytes) {
  if (flags.accuracy.empty() && scene.solve_given) {
    say_run(scene, quiet, picture_bytes);
    return std::nullopt;
  }
  Plan plan = flags.accuracy.empty() ? quick_plan(scene.model, scene.start, scene.duration,
                                                  target_from(scene.accuracy), method, stop)
                                     : searched(scene, flags, method, quiet, stop);
  scene.settings = plan.settings;
  scene.solve_given = true;
  if (!quiet) tell("taut: {}: {}\n", scene.name, plan_text(plan));
  say_run(scene, quiet, picture_bytes);
  return plan;
}

std::string plan_text(const Plan& plan) {
  return fmt::format("{}; {}", plan.why, accuracy_sentence(plan));
}

nlohmann::ordered_json plan_to_json(const Plan& plan) {
  nlohmann::ordered_json json{{"why", plan.why},
                              {"searched", plan.searched},
                              {"reached", plan.reached},
                              {"error_kind", name_of(plan.kind)},
                              {"wanted", plan.wanted},
                              {"estimated_error", nullptr},
                              {"size", plan.size},
                              {"judged_until", plan.judged_until},
                              {"judged_share", plan.judged_share()},
                              {"predicted_seconds", plan.predicted_seconds}};
  if (plan.estimated_error) json["estimated_error"] = *plan.estimated_error;
  return json;
}

void print_accuracy(const Plan& plan) {
  tell("accuracy: {}\n", accuracy_sentence(plan));
}

void add_certify(Verb& verb, bool& certify) {
  verb.add_flag(
      "--certify", certify,
      "Run the scene a second time beside it, finer and by another kind of method, and say how far the two "
      "are apart");
}

void print_certificate(const Certificate& certificate) {
  tell("certificate: {}\n", certificate_text(certificate));
}

}  // namespace taut
