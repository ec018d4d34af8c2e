#include "measure/planner.h"

#include <fmt/format.h>

#include <algorithm>

#include "measure/cost.h"
#include "measure/method_variants.h"
#include "measure/work_precision.h"
#include "methods/registry.h"
#include "model/measures.h"

namespace taut {
namespace {

// Predicted seconds: of one short run, and of all together, which may cost twice what the scene's run will,
// within these bounds.
constexpr double most_run = 16.0, least_work = 60.0, most_work = 90.0;
constexpr double safety = 0.9;  // of the target

std::string settings_text(const Settings& settings) {
  std::string text = fmt::format("{} at {} steps/s", settings.method, settings.steps_per_second());
  for (const auto& [name, value] : settings.values) {
    if (name == "passes") text += fmt::format(", {} passes", std::get<double>(value));
    if (const auto* word = std::get_if<std::string>(&value)) text += fmt::format(", {} {}", name, *word);
  }
  return text;
}

Plan plan_without_truth(const Truth& truth, double wanted) {
  Plan plan;
  plan.settings = complete_settings({"xpbd", {{"steps_per_second", 600.0}}});
  plan.wanted = wanted;
  plan.why = fmt::format("{}: this is the default, because no error can be judged: {}",
                         settings_text(plan.settings), truth.remark);
  return plan;
}

// The truth, for one kind of error alone.
Truth only_kind(Truth truth, ErrorKind kind) {
  for (const ErrorKind other : all_error_kinds)
    if (other != kind) truth.smallest[other].reset();
  return truth;
}

struct Tried {
  Settings settings;
  double error = infinity;
  double work = infinity;  // s, predicted
};

// What the walk over the grid found.
struct Search {
  std::optional<Tried> cheapest;  // of those that are good enough
  Tried best;                     // the least error
  std::size_t runs = 0;
};

// `whole`: the scene's duration over the truth's horizon.
Search search(const Model& model, const State& start, const Truth& truth, ErrorKind kind, double good_enough,
              double whole, const std::vector<MethodVariant>& curves, const StopTest& stop) {
  Search found;
  GridWalk walk(model, curves, truth, most_run);
  double work = 0.0;
  while (const std::optional<GridPoint> point = walk.next()) {
    Tried tried;
    tried.settings = settings_at_place(curves[point->curve], point->fineness, point->row);
    const JudgedRun run = judge_run(model, start, truth, tried.settings, stop);
    walk.record(run);
    ++found.runs;
    tried.work = predicted_seconds(model, tried.settings.method, run.counts,
                                   truth.horizon() * tried.settings.steps_per_second());
    // What is smaller can't be told from the truth.
    tried.error = run.diverged ? infinity : std::max(*run.errors[kind], *truth.smallest[kind]);
    work += tried.work;
    if (tried.error <= good_enough && (!found.cheapest || tried.work < found.cheapest->work)) {
      found.cheapest = tried;
      walk.forbid_above(tried.work);
    }
    const double worth = std::clamp(2.0 * whole * tried.work, least_work, most_work);
    if (tried.error < found.best.error) found.best = std::move(tried);
    if (work > worth) break;
  }
  return found;
}

}  // namespace

double wanted_error(const AccuracyTarget& target, const Model& model, const State& start) {
  return target.metres ? target.error / scene_size(model, start) : target.error;
}

ErrorKind judging_kind(const Truth& truth, ErrorKind kind, double wanted) {
  const auto can_judge = [&](ErrorKind tried) { return truth.smallest[tried].value_or(infinity) <= wanted; };
  if (can_judge(kind)) return kind;
  if (can_judge(ErrorKind::sag)) return ErrorKind::sag;
  return truth.smallest[kind] ? kind : ErrorKind::sag;
}

Plan make_plan(const Model& model, const State& start, const Truth& truth, double duration,
               const AccuracyTarget& target, std::string_view only, const StopTest& stop) {
  const double wanted = wanted_error(target, model, start);
  const ErrorKind kind = judging_kind(truth, target.kind, wanted);
  if (!truth.smallest[kind]) return plan_without_truth(truth, wanted);
  const std::vector<std::string> methods =
      only.empty() ? std::vector<std::string>{} : std::vector{std::string(only)};
  const Search found = search(model, start, only_kind(truth, kind), kind, safety * wanted,
                              duration / truth.horizon(), variants_of(model, start, methods).variants, stop);
  if (found.best.error == infinity) return plan_without_truth(truth, wanted);
  const Tried& chosen = found.cheapest ? *found.cheapest : found.best;

  Plan plan;
  plan.settings = chosen.settings;
  plan.reached = chosen.error <= wanted;
  plan.kind = kind;
  plan.wanted = wanted;
  plan.estimated_error = chosen.error;
  plan.looked_until = truth.horizon();
  plan.predicted_seconds = chosen.work * duration / truth.horizon();
  plan.runs = found.runs;
  plan.why = fmt::format(
      "{}: {} {} error {:.2g} of {:.2g} wanted, over {:.3g} s, where {}; about {:.2g} s of work; the {} of "
      "{} "
      "short runs",
      settings_text(plan.settings), plan.reached ? "estimated" : "not reached, the best has", name_of(kind),
      chosen.error, wanted, plan.looked_until, truth.how, plan.predicted_seconds,
      plan.reached ? "cheapest that is good enough" : "best", plan.runs);
  return plan;
}

}  // namespace taut
