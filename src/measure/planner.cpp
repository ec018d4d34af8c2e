#include "measure/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/failure.h"
#include "measure/cost.h"
#include "measure/curves.h"
#include "measure/measures.h"
#include "measure/sampled_run.h"
#include "measure/work_precision.h"
#include "methods/registry.h"

namespace taut {
namespace {

constexpr double most_work = 1.5;      // s, predicted, of all short runs together
constexpr double largest_share = 0.4;  // of that, of one run
constexpr double agree_within = 0.25, settle_within = 0.25, safety = 0.7;  // of the target
constexpr int instants = 8;
constexpr int most_horizons = 3;  // each a quarter of the one before, where nothing agrees on the longer one
constexpr int most_levels = 16, most_rows = 3;

// A short run.
struct Probe {
  std::size_t method = 0;
  Settings settings;
  std::vector<State> states;
  double work = 0.0;           // s, predicted
  std::size_t coarser = none;  // place of the same with half the steps
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

// Two methods that agree, and on how many instants.
struct Agreement {
  const Probe *fine = nullptr, *other = nullptr;
  std::size_t instants = 0;
};

struct Best {
  const Probe* probe = nullptr;
  double error = infinity;
};

class Planner {
 public:
  Planner(const Model& model, const State& start, double duration)
      : model_(model), start_(start), curves_(curves_for(model).curves), times_(probe_times(duration)) {}

  void look(ErrorKind kind, double error, std::string_view only);
  Agreement agreement(ErrorKind kind, double error) const;
  Best cheapest(const Agreement& agreement, ErrorKind kind, double error, std::string_view only) const;
  const std::vector<double>& times() const { return times_; }
  std::size_t runs() const { return probes_.size(); }

 private:
  std::vector<double> probe_times(double duration) const;
  void try_point(std::size_t curve, const GridPoint& point);
  double error_between(const Probe& a, const Probe& truth, ErrorKind kind, std::size_t count) const;
  double own_change(const Probe& probe, ErrorKind kind, std::size_t count) const;

  const Model& model_;
  const State& start_;
  std::vector<Curve> curves_;
  std::vector<double> times_;
  std::vector<Probe> probes_;
  std::vector<std::vector<double>> last_work_ = std::vector<std::vector<double>>(
      curves_.size(), std::vector<double>(most_rows, 0.0));  // s, a curve, a row
  std::vector<std::vector<std::size_t>> last_place_ =
      std::vector<std::vector<std::size_t>>(curves_.size(), std::vector<std::size_t>(most_rows, Probe::none));
  double work_ = 0.0;
};

// As long as sixteen doublings' worth of coarse runs of all methods can be paid for; whole sixtieths of a
// second.
std::vector<double> Planner::probe_times(double duration) const {
  constexpr double finest = 960.0;  // steps per second that the longest probe has to afford
  StepReport second;
  second.link_solves = static_cast<std::int64_t>(finest) * static_cast<std::int64_t>(model_.links.size());
  const double per_second =
      predicted_seconds(model_, second, 0.0) * static_cast<double>(std::max<std::size_t>(1, curves_.size()));
  const double horizon = std::min(duration, most_work / std::max(1e-12, per_second));
  std::vector<double> times;
  for (int i = 1; i <= instants; ++i) {
    const double time = std::max(1.0, std::round(horizon * i / instants * 60.0)) / 60.0;
    if (times.empty() || time > times.back()) times.push_back(time);
  }
  return times;
}

void Planner::try_point(std::size_t curve, const GridPoint& point) {
  double& last = last_work_[curve][static_cast<std::size_t>(point.row)];
  StepReport least;
  least.link_solves = static_cast<std::int64_t>(times_.back() * point.steps_per_second()) * point.passes() *
                      static_cast<std::int64_t>(model_.links.size());
  if (!curves_[curve].relaxes)
    least.factorisations = static_cast<std::int64_t>(times_.back() * point.steps_per_second());
  const double expected = std::max(2.0 * last, predicted_seconds(model_, least, 0.0));
  if (expected > largest_share * most_work || work_ + expected > most_work) return;
  Probe probe{curves_[curve].method,
              settings_at(curves_[curve], point.steps_per_second(), point.passes()),
              {},
              0.0,
              last_place_[curve][static_cast<std::size_t>(point.row)]};
  try {
    SampledRun run = sampled_run(model_, start_, probe.settings, times_, chart_guard);
    probe.work = last = predicted_seconds(model_, run.report, times_.back() * point.steps_per_second());
    work_ += probe.work;
    if (run.diverged) return;
    probe.states = std::move(run.states);
    last_place_[curve][static_cast<std::size_t>(point.row)] = probes_.size();
    probes_.push_back(std::move(probe));
  } catch (const BadRequest&) {
    // Springs too stiff for this step.
  }
}

// Levels of equal cost, as GridWalk has them.
void Planner::look(ErrorKind kind, double error, std::string_view only) {
  for (int level = 0; level < most_levels; ++level) {
    for (std::size_t curve = 0; curve < curves_.size(); ++curve)
      for (int row = 0; row < (curves_[curve].relaxes ? most_rows : 1); ++row)
        if (level - 2 * row >= 0) try_point(curve, {curve, level - 2 * row, row});
    const Agreement found = agreement(kind, error);
    if (found.instants == times_.size() && cheapest(found, kind, error, only).error <= safety * error) return;
  }
}

double Planner::error_between(const Probe& a, const Probe& truth, ErrorKind kind, std::size_t count) const {
  return error_against(model_, start_, kind, std::span(a.states).first(count),
                       std::span(truth.states).first(count));
}

// What half the step changes: about the error of a first-order method, three times that of a second-order
// one.
double Planner::own_change(const Probe& probe, ErrorKind kind, std::size_t count) const {
  return probe.coarser == Probe::none ? infinity : error_between(probes_[probe.coarser], probe, kind, count);
}

// The pair of different methods that agrees longest; of those, the one with the surest member. Agreement
// alone would not do: verlet and xpbd, say, make the same error with the same step.
Agreement Planner::agreement(ErrorKind kind, double error) const {
  Agreement best;
  double best_change = infinity;
  const auto agree = [&](const Probe& a, const Probe& b, std::size_t count) {
    return error_between(a, b, kind, count) <= agree_within * error &&
           own_change(a, kind, count) <= settle_within * error &&
           own_change(b, kind, count) <= settle_within * error;
  };
  for (const Probe& a : probes_)
    for (const Probe& b : probes_) {
      if (a.method >= b.method || a.coarser == Probe::none || b.coarser == Probe::none) continue;
      std::size_t count = std::max<std::size_t>(1, best.instants);  // less is of no interest
      if (!agree(a, b, count)) continue;
      while (count < times_.size() && agree(a, b, count + 1)) ++count;
      const double change_a = own_change(a, kind, count), change_b = own_change(b, kind, count);
      const double change = std::min(change_a, change_b);
      if (count == best.instants && change >= best_change) continue;
      best = {change_a <= change_b ? &a : &b, change_a <= change_b ? &b : &a, count};
      best_change = change;
    }
  return best;
}

// The cheapest probe that is good enough; where none is, the one of least error.
Best Planner::cheapest(const Agreement& agreement, ErrorKind kind, double error,
                       std::string_view only) const {
  Best good, least;
  for (const Probe& probe : probes_) {
    if (!only.empty() && probe.settings.method != only) continue;
    const Probe& measure = &probe == agreement.fine ? *agreement.other : *agreement.fine;
    const double its_error = error_between(probe, measure, kind, agreement.instants);
    if (its_error < least.error) least = {&probe, its_error};
    const bool cheaper = good.probe == nullptr || probe.work < 0.99 * good.probe->work ||
                         (probe.work < 1.01 * good.probe->work && its_error < good.error);
    if (its_error <= safety * error && cheaper) good = {&probe, its_error};
  }
  return good.probe != nullptr ? good : least;
}

std::string settings_text(const Settings& settings) {
  std::string text = fmt::format("{} at {} steps/s", settings.method, settings.steps_per_second());
  for (const auto& [name, value] : settings.values) {
    if (name == "passes") text += fmt::format(", {} passes", std::get<double>(value));
    if (const auto* word = std::get_if<std::string>(&value)) text += fmt::format(", {} {}", name, *word);
  }
  return text;
}

Plan plan_without_agreement(double wanted) {
  Plan plan;
  plan.settings = complete_settings({"xpbd", {{"steps_per_second", 600.0}, {"passes", 1.0}}});
  plan.wanted = wanted;
  plan.why = settings_text(plan.settings) + ": no two methods agree on anything, so this is the default";
  return plan;
}

}  // namespace

Plan make_plan(const Model& model, const State& start, double duration, const AccuracyTarget& target,
               std::string_view only) {
  const double wanted = target.metres ? target.error / scene_size(model, start) : target.error;
  // Chaos ends agreement; what it leaves no trace of is then to be found over a shorter time.
  std::optional<Planner> planner;
  Agreement agreement;
  std::size_t runs = 0;
  double horizon = duration;
  for (int attempt = 0; attempt < most_horizons && agreement.instants == 0; ++attempt, horizon /= 4.0) {
    planner.emplace(model, start, horizon);
    planner->look(target.kind, wanted, only);
    runs += planner->runs();
    agreement = planner->agreement(target.kind, wanted);
  }
  ErrorKind kind = target.kind;
  if (agreement.instants == 0 && kind == ErrorKind::trajectory) {
    kind = ErrorKind::sag;
    agreement = planner->agreement(kind, wanted);
  }
  if (agreement.instants == 0) return plan_without_agreement(wanted);
  const Best best = planner->cheapest(agreement, kind, wanted, only);
  if (best.probe == nullptr) return plan_without_agreement(wanted);

  Plan plan;
  plan.settings = best.probe->settings;
  plan.reached = best.error <= wanted;
  plan.kind = kind;
  plan.wanted = wanted;
  plan.estimated_error = best.error;
  plan.looked_until = planner->times()[agreement.instants - 1];
  plan.predicted_seconds = best.probe->work * duration / planner->times().back();
  plan.runs = runs;
  plan.why = fmt::format(
      "{}: {} {} error {:.2g} of {:.2g} wanted, over {:.3g} s, on which {} and {} agree; about {:.2g} s of "
      "work; the "
      "{} of {} short runs",
      settings_text(plan.settings), plan.reached ? "estimated" : "not reached, the best has", name_of(kind),
      best.error, wanted, plan.looked_until, settings_text(agreement.fine->settings),
      settings_text(agreement.other->settings), plan.predicted_seconds,
      plan.reached ? "cheapest that is good enough" : "best", plan.runs);
  return plan;
}

}  // namespace taut
