#include "measure/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "base/processor_time.h"
#include "measure/cost.h"
#include "measure/method_variants.h"
#include "measure/pace.h"
#include "measure/rounding.h"
#include "measure/work_precision.h"
#include "methods/registry.h"

namespace taut {
namespace {

// Predicted seconds: of one short run, and of all together, which may cost twice what the scene's run will,
// within these bounds.
constexpr double most_run = 16.0, least_work = 60.0, most_work = 90.0;
constexpr double safety = 0.9;         // of the target
constexpr double further = 1.2;        // than a truth reaches: a first plan that is kept
constexpr double prices_differ = 2.0;  // by how much a method's price may be off before it is measured

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

// Processor time that runs took over what was predicted, method by method.
class MeasuredPrices {
 public:
  void add(const std::string& method, double predicted, double measured) {
    Sums& sums = sums_[method];
    sums.predicted += predicted;
    sums.measured += measured;
  }
  // Near 1 until there is something to go by.
  double factor(const std::string& method) const {
    constexpr double little = 1e-3;  // s
    const auto found = sums_.find(method);
    return found == sums_.end() ? 1.0
                                : (found->second.measured + little) / (found->second.predicted + little);
  }

 private:
  struct Sums {
    double predicted = 0.0, measured = 0.0;
  };
  std::map<std::string, Sums, std::less<>> sums_;
};

class GridSearch {
 public:
  GridSearch(const Model& model, const State& start, const Truth& truth, ErrorKind kind, double wanted,
             const SearchRules& rules)
      : model_(model),
        start_(start),
        truth_(only_kind(truth, kind)),
        kind_(kind),
        wanted_(wanted),
        rules_(rules) {}

  // Whether a run with these settings is good enough, as far as the truth goes.
  bool finds_good(const Settings& settings) { return judged(settings) && good(tried_.back()); }
  // `whole`: the scene's duration over the truth's horizon.
  void run(const Settings& first, double whole);
  // The cheapest that is good enough, by measured prices; else the best; nothing where there is no error at
  // all.
  const Tried* chosen() const;
  double seconds(const Tried& tried) const { return tried.work * prices_.factor(tried.settings.method); }
  bool good(const Tried& tried) const { return tried.error <= safety * wanted_; }
  std::size_t runs() const { return tried_.size(); }
  bool out_of_time() const { return out_of_time_; }

 private:
  bool time_is_up() const { return rules_.time_is_up && rules_.time_is_up(); }
  std::optional<JudgedRun> judged(const Settings& settings);

  const Model& model_;
  const State& start_;
  Truth truth_;
  ErrorKind kind_;
  double wanted_;
  const SearchRules& rules_;
  std::vector<Tried> tried_;
  MeasuredPrices prices_;
  bool out_of_time_ = false;
};

// Nothing where the time is up before the run's end.
std::optional<JudgedRun> GridSearch::judged(const Settings& settings) {
  const double begin = processor_seconds();
  JudgedRun run;
  try {
    run = judge_run(model_, start_, truth_, settings,
                    [&] { return time_is_up() || (rules_.stop && rules_.stop()); });
  } catch (const Interrupted&) {
    stop_if_told(rules_.stop);
    out_of_time_ = true;
    return std::nullopt;
  }
  Tried& tried = tried_.emplace_back();
  tried.settings = settings;
  tried.work = predicted_seconds(model_, settings.method, run.counts, static_cast<double>(run.steps));
  prices_.add(settings.method, tried.work, processor_seconds() - begin);
  // What is smaller can't be told from the truth.
  if (!run.diverged)
    tried.error =
        std::max(*run.errors[kind_], *truth_.smallest[kind_]) + rounding_error(model_, start_, settings);
  return run;
}

void GridSearch::run(const Settings& first, double whole) {
  if (!judged(first)) return;
  const std::vector<std::string> methods =
      rules_.only.empty() ? std::vector<std::string>{} : std::vector{std::string(rules_.only)};
  std::vector<MethodVariant> curves = variants_of(model_, start_, methods).variants;
  // What keeps no energy whatever the step may be near the truth as far as that goes, and nowhere beyond.
  if (rules_.only.empty())
    std::erase_if(curves,
                  [](const MethodVariant& curve) { return curve.can.keeps.energy == Keeping::not_kept; });
  GridWalk walk(model_, curves, truth_, most_run);
  double work = 0.0, cheapest = infinity;
  if (good(tried_.back())) walk.forbid_above(prices_differ * (cheapest = tried_.back().work));
  while (const std::optional<GridPoint> point = walk.next()) {
    const std::optional<JudgedRun> run =
        judged(settings_at_place(curves[point->curve], point->fineness, point->row));
    if (!run) return;
    walk.record(*run);
    const Tried& tried = tried_.back();
    work += tried.work;
    if (good(tried) && tried.work < cheapest) {
      cheapest = tried.work;
      walk.forbid_above(prices_differ * cheapest);
    }
    if (work > std::clamp(2.0 * whole * tried.work, least_work, most_work)) return;
  }
}

const Tried* GridSearch::chosen() const {
  const Tried* best = nullptr;
  for (const Tried& tried : tried_) {
    if (tried.error == infinity) continue;
    const bool better = best == nullptr || (good(tried) ? !good(*best) || seconds(tried) < seconds(*best)
                                                        : !good(*best) && tried.error < best->error);
    if (better) best = &tried;
  }
  return best;
}

}  // namespace

ErrorKind judging_kind(const Truth& truth, ErrorKind kind, double wanted) {
  const auto can_judge = [&](ErrorKind tried) { return truth.smallest[tried].value_or(infinity) <= wanted; };
  if (can_judge(kind)) return kind;
  if (can_judge(ErrorKind::sag)) return ErrorKind::sag;
  return truth.smallest[kind] ? kind : ErrorKind::sag;
}

Plan make_plan(const Model& model, const State& start, const Truth& truth, const AccuracyTarget& target,
               const Plan& first, const SearchRules& rules) {
  const double wanted = wanted_error(target, model, start);
  const ErrorKind kind = judging_kind(truth, target.kind, wanted);
  Plan plan = first;
  plan.searched = true;
  if (!truth.smallest[kind]) {
    plan.why += fmt::format("; no search, because nothing can judge it: {}", truth.remark);
    return plan;
  }
  GridSearch search(model, start, truth, kind, wanted, rules);
  const bool judged_further = first.reached && first.judged_until > further * truth.horizon();
  if (judged_further && search.finds_good(first.settings)) {
    plan.why +=
        fmt::format("; by rule, because what is true of it is known for no more than the first {:.3g} s",
                    truth.horizon());
    return plan;
  }
  search.run(first.settings, first.duration / truth.horizon());
  const Tried* chosen = search.chosen();
  if (chosen == nullptr) {
    plan.why += search.out_of_time() ? "; the time was up before anything was judged"
                                     : fmt::format("; none of {} short runs came to an end", search.runs());
    return plan;
  }
  const bool good = search.good(*chosen);
  plan.settings = chosen->settings;
  plan.reached = chosen->error <= wanted;
  plan.kind = kind;
  plan.wanted = wanted;
  plan.estimated_error = chosen->error;
  plan.judged_until = truth.horizon();
  plan.predicted_seconds = search.seconds(*chosen) * plan.duration / truth.horizon();
  plan.runs = first.runs + search.runs();
  plan.why =
      fmt::format("{} of {} short runs{}, judged where {}; about {:.2g} s of work",
                  good ? "the cheapest that is good enough" : "the best, but not good enough,", search.runs(),
                  search.out_of_time() ? " until the time was up" : "", truth.how, plan.predicted_seconds);
  const Settings usual = complete_settings({plan.settings.method, {}});
  // What a method that chooses its steps makes of the rest, its tolerance sees to.
  const double rate = pace_of(model, plan.settings), least = pace_of(model, usual);
  if (!plan.judged_to_the_end() && !usual.chooses_steps() && rate < least) {
    set_pace(model, plan.settings, least);
    plan.predicted_seconds *= least / rate;
    plan.why += "; with no coarser step than usual, as the run can't be judged to its end";
  }
  plan.why = settings_text(plan.settings) + ": " + plan.why;
  return plan;
}

}  // namespace taut
