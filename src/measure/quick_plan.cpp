#include "measure/quick_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/failure.h"
#include "measure/pace.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "probe_ladder.h"

namespace taut {
namespace {

constexpr double within_target = 0.6;         // of the target
constexpr double most_refinement = 16.0;      // beyond the finest step that was judged
constexpr double largest_extrapolated = 0.5;  // error, beyond which nothing can be told from it

// What the probes may cost, predicted (s).
double most_probing(const Model& model) {
  constexpr double small = 0.2, many_links = 1e4;
  return small * std::clamp(static_cast<double>(model.links.size()) / many_links, 1.0, 2.0);
}

bool alike(std::string_view a, std::string_view b) {
  return find_method(a)->can.family == find_method(b)->can.family;
}

// One of a ladder's runs that there is an estimate of.
struct Choice {
  const ProbeLadder* ladder = nullptr;
  const Probe* probe = nullptr;
  std::size_t good = 0;  // instants for which it is within the target
};

class QuickSearch {
 public:
  QuickSearch(const Model& model, const State& start, double duration, ErrorKind kind, double wanted,
              std::string_view only, const StopTest& stop, std::optional<double> most_seconds)
      : scene_{model, start, kind, longest_reach(model), {}},
        duration_(duration),
        wanted_(wanted),
        scales_(time_scales(model, start, duration)),
        budget_(most_seconds.value_or(most_probing(model))),
        stop_(stop) {
    for (ProbeCandidate& candidate : probe_candidates(model, start, scales_, wanted, only))
      ladders_.emplace_back(std::move(candidate));
    only_one_kind_ = std::ranges::all_of(ladders_, [&](const ProbeLadder& ladder) {
      return alike(method_of(ladder), method_of(ladders_.front()));
    });
    scene_.times = instants(reach_in_time());
  }

  void run();

  Plan plan() const;

 private:
  static const std::string& method_of(const ProbeLadder& ladder) {
    return ladder.candidate().settings.method;
  }
  // Whether one ladder can speak for another: another method, of another kind where there is one.
  bool independent(const ProbeLadder& a, const ProbeLadder& b) const {
    return only_one_kind_ ? method_of(a) != method_of(b) : !alike(method_of(a), method_of(b));
  }
  double reach_in_time() const;
  std::vector<double> instants(double until) const;
  ProbeLadder* next();
  bool can_confirm(const ProbeLadder& ladder) const;
  bool confirmed(const Choice& choice) const;
  std::vector<double> errors_of(const ProbeLadder& ladder, const Probe& probe) const;
  std::vector<Choice> choices() const;
  std::optional<Choice> cheapest_good() const;
  Plan best_plan() const;
  Plan cheapest_plan(const Choice& good) const;
  std::optional<Plan> extrapolated() const;
  Plan longest_plan(const std::vector<Choice>& all) const;
  Plan plan_by_rule() const;
  Plan plan_for(const Settings& settings) const;
  double floor_rate(const ProbeLadder& ladder) const;
  std::string methods_tried() const;
  std::vector<std::string> reasons() const;

  ProbeScene scene_;
  double duration_, wanted_;
  TimeScales scales_;
  double budget_, spent_ = 0.0;
  bool only_one_kind_ = false;
  std::size_t runs_ = 0;
  const StopTest& stop_;
  std::vector<ProbeLadder> ladders_;
};

// Climbs ladders until one is good enough, and another kind of method says so too. Where nothing agrees with
// anything over that much of the run, over less of it.
void QuickSearch::run() {
  constexpr double less = 0.125;
  constexpr int looks = 3;
  for (int look = 0; look < looks; ++look) {
    while (ProbeLadder* ladder = next()) {
      ladder->climb(scene_, budget_ - spent_, stop_);
      spent_ += ladder->last_work();
      ++runs_;
    }
    const double until = less * scene_.times.back();
    if (!choices().empty() || until < 1.0 / 60.0) return;
    scene_.times = instants(until);
    spent_ = 0.5 * budget_;
    for (ProbeLadder& ladder : ladders_) ladder.begin_again();
  }
}

// How far into the run (s) a handful of runs with the rule's step can go.
double QuickSearch::reach_in_time() const {
  constexpr double runs_worth = 6.0;
  double cheapest = infinity;
  for (const ProbeLadder& ladder : ladders_)
    // How many steps a method takes that chooses them can't be foreseen well enough.
    if (!ladder.candidate().settings.chooses_steps() || ladders_.size() == 1)
      cheapest = std::min(cheapest, ladder.work_of(scene_.model, ladder.candidate().rule_rate, 1.0));
  const double affordable = budget_ / (runs_worth * cheapest);
  return std::min(affordable, duration_);
}

// Whole sixtieths, on which steps of 60 · 2^n per second end; at the end of the run that. Many, where they
// cost little: what two runs make of an impact differs most for a moment.
std::vector<double> QuickSearch::instants(double until) const {
  const std::size_t most =
      std::clamp<std::size_t>(200000 / std::max<std::size_t>(1, scene_.model.masses.size()), 8, 64);
  if (until < duration_) until = std::min(duration_, std::max(1.0, std::floor(60.0 * until)) / 60.0);
  std::vector<double> times;
  for (std::size_t i = 1; i < most; ++i) {
    const double time = std::round(60.0 * until * static_cast<double>(i) / static_cast<double>(most)) / 60.0;
    if (time > (times.empty() ? 0.0 : times.back()) && time < until) times.push_back(time);
  }
  times.push_back(until);
  return times;
}

// The ladder whose next run is predicted to be cheapest, of those where it can matter.
ProbeLadder* QuickSearch::next() {
  const std::optional<Choice> good = cheapest_good();
  const bool unconfirmed = good && !confirmed(*good);
  ProbeLadder* best = nullptr;
  double least = infinity;
  for (ProbeLadder& ladder : ladders_) {
    if (ladder.ended()) continue;
    const double work = ladder.next_work(scene_);
    // A run shows how good the one before it is, which costs half as much.
    const bool cheaper = !good || work <= 2.0 * good->probe->work;
    const bool matters = cheaper || (unconfirmed && independent(ladder, *good->ladder));
    if (!matters || spent_ + work > budget_) continue;
    if (work < least) {
      least = work;
      best = &ladder;
    }
  }
  return best;
}

// What is estimated of a probe, at every instant from the largest up to then: its distance from the ladder's
// next one, and from the finest run of other methods beyond what those are estimated to be off themselves,
// which has nothing to do with what it is off: squares add up.
std::vector<double> QuickSearch::errors_of(const ProbeLadder& ladder, const Probe& probe) const {
  std::vector<double> errors = probe.errors;
  for (const ProbeLadder& other : ladders_) {
    const Probe* judge = other.finest_judged();
    // Where one kind of method is all there is, other numbers of passes have a say, too.
    const bool has_a_say = only_one_kind_ ? &other != &ladder : independent(ladder, other);
    if (judge == nullptr || !has_a_say) continue;
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(errors.size(), judge->errors.size()); ++i) {
      largest = std::max(largest, distance(scene_, probe.samples[i], judge->samples[i]));
      if (judge->errors[i] > wanted_) continue;
      const double beyond = largest * largest - judge->errors[i] * judge->errors[i];
      errors[i] = std::max(errors[i], std::sqrt(std::max(0.0, beyond)));
    }
  }
  return errors;
}

// Whether a ladder has a run that can speak for those of others to the end. With steps that are longer than
// what theory asks for, two runs may agree on the same wrong impact.
bool QuickSearch::can_confirm(const ProbeLadder& ladder) const {
  const Probe* judge = ladder.finest_judged();
  return judge != nullptr && judge->errors.size() == scene_.times.size() &&
         ladder.finest_rate() >= ladder.candidate().rule_rate &&
         judge->errors.back() <= within_target * wanted_;
}

bool QuickSearch::confirmed(const Choice& choice) const {
  return std::ranges::any_of(ladders_, [&](const ProbeLadder& other) {
    return independent(other, *choice.ladder) && can_confirm(other);
  });
}

std::vector<Choice> QuickSearch::choices() const {
  std::vector<Choice> all;
  for (const ProbeLadder& ladder : ladders_)
    for (const Probe& probe : ladder.probes()) {
      const std::vector<double> errors = errors_of(ladder, probe);
      const auto within = [&](double error) { return error <= within_target * wanted_; };
      const auto good = static_cast<std::size_t>(std::ranges::find_if_not(errors, within) - errors.begin());
      if (good > 0) all.push_back({&ladder, &probe, good});
    }
  return all;
}

std::optional<Choice> QuickSearch::cheapest_good() const {
  std::optional<Choice> best;
  for (const Choice& choice : choices())
    if (choice.good == scene_.times.size() && (!best || choice.probe->work < best->probe->work))
      best = choice;
  return best;
}

Plan QuickSearch::plan_for(const Settings& settings) const {
  Plan plan;
  plan.settings = settings;
  plan.kind = scene_.kind;
  plan.wanted = wanted_;
  plan.duration = duration_;
  plan.size = scene_size(scene_.model, scene_.start);
  plan.runs = runs_;
  return plan;
}

// What a run that was not judged to its end is never coarser than. What a method that chooses its steps makes
// of the rest, its tolerance sees to.
double QuickSearch::floor_rate(const ProbeLadder& ladder) const {
  if (ladder.candidate().settings.chooses_steps()) return ladder.candidate().rule_rate;
  const Settings usual = complete_settings({ladder.candidate().settings.method, {}});
  return std::max(pace_of(scene_.model, usual), ladder.candidate().rule_rate);
}

// The runs tell how errors fall with the step, but none that is fine enough was cheap enough to be judged.
// Where that is the run that judged the finest, its error is known well enough; a finer one, which was never
// made, is promised no more than what the finest keeps to.
std::optional<Plan> QuickSearch::extrapolated() const {
  std::optional<Plan> best;
  for (const ProbeLadder& ladder : ladders_) {
    const Probe* finest = ladder.finest_judged();
    if (finest == nullptr || finest->errors.size() < scene_.times.size()) continue;
    const int order = ladder.candidate().order;
    const std::vector<double> errors = errors_of(ladder, *finest);
    const double needed = std::pow(errors.back() / (within_target * wanted_), 1.0 / order);
    if (!(errors.back() < largest_extrapolated) || needed > 2.0 * most_refinement) continue;
    const double refinement = std::exp2(std::ceil(std::log2(std::max(needed, 2.0))));
    const bool was_made = refinement == 2.0;
    const auto kept =
        std::ranges::find_if(errors, [&](double error) { return error > wanted_; }) - errors.begin();
    const auto last = was_made ? errors.size() : static_cast<std::size_t>(kept);
    Plan plan = plan_for(ladder.settings_at(scene_.model, finest->rate * refinement));
    if (last > 0) {
      plan.estimated_error = errors[last - 1] / (was_made ? std::exp2(order) : 1.0);
      plan.judged_until = scene_.times[last - 1];
    }
    plan.predicted_seconds = finest->work * refinement * duration_ / scene_.times.back();
    plan.why =
        fmt::format("how the errors of {} short runs with {} fall with the step tells that this is needed",
                    runs_, methods_tried());
    if (!best || plan.predicted_seconds < best->predicted_seconds) best = std::move(plan);
  }
  return best;
}

std::string QuickSearch::methods_tried() const {
  std::vector<std::string> names;
  for (const ProbeLadder& ladder : ladders_)
    if (ladder.runs() > 0 && std::ranges::find(names, ladder.candidate().settings.method) == names.end())
      names.push_back(ladder.candidate().settings.method);
  if (names.size() < 2) return names.empty() ? "no method" : names.front();
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

std::vector<std::string> QuickSearch::reasons() const {
  std::vector<std::string> lines;
  const auto scale = [&](double value, std::string_view what) {
    if (value < infinity) lines.push_back(fmt::format("{}: {:.2g} ms", what, 1e3 * value));
  };
  scale(scales_.fall, "what gravity does to a link takes √(l/g)");
  scale(scales_.sideways, "links swing from side to side within √(m l/T)");
  scale(scales_.spring, "the stiffest springs allow explicit steps of 2/ω");
  scale(scales_.motion, "pins or masses at the start pass a link in");
  scale(scales_.impact, "what hits moves by its own size in");
  for (const ProbeLadder& ladder : ladders_) lines.push_back(ladder.account(scene_.model));
  return lines;
}

Plan QuickSearch::cheapest_plan(const Choice& good) const {
  Plan plan = plan_for(good.ladder->settings_at(scene_.model, good.probe->rate));
  plan.estimated_error = errors_of(*good.ladder, *good.probe).back();
  plan.judged_until = scene_.times.back();
  plan.predicted_seconds = good.probe->work * duration_ / plan.judged_until;
  plan.why =
      fmt::format("the cheapest of {} short runs with {} that is good enough{}", runs_, methods_tried(),
                  confirmed(good) ? "" : ", by its own word: no other kind of method could be asked");
  return plan;
}

// By the run that is good for longest, of those the cheapest: with the steps of the finer one that says so.
Plan QuickSearch::longest_plan(const std::vector<Choice>& all) const {
  const auto best = std::ranges::max_element(all, [](const Choice& a, const Choice& b) {
    return a.good != b.good ? a.good < b.good : a.probe->work > b.probe->work;
  });
  Plan plan = plan_for(best->ladder->settings_at(scene_.model, 2.0 * best->probe->rate));
  plan.estimated_error = errors_of(*best->ladder, *best->probe)[best->good - 1];
  plan.judged_until = scene_.times[best->good - 1];
  plan.predicted_seconds = 2.0 * best->probe->work * duration_ / scene_.times.back();
  plan.why = fmt::format("of {} short runs with {} the one that keeps longest to what finer ones do", runs_,
                         methods_tried());
  return plan;
}

Plan QuickSearch::plan_by_rule() const {
  const ProbeLadder& first = ladders_.front();
  const double rate = std::max(floor_rate(first), first.finest_rate());
  Plan plan = plan_for(first.settings_at(scene_.model, rate));
  plan.predicted_seconds = first.work_of(scene_.model, rate, duration_);
  plan.why = fmt::format("by rule, because {} short runs with {} agree on nothing", runs_, methods_tried());
  return plan;
}

Plan QuickSearch::best_plan() const {
  if (const std::optional<Choice> good = cheapest_good()) return cheapest_plan(*good);
  if (std::optional<Plan> finer = extrapolated()) return *std::move(finer);
  const std::vector<Choice> all = choices();
  return all.empty() ? plan_by_rule() : longest_plan(all);
}

Plan QuickSearch::plan() const {
  Plan plan = best_plan();
  plan.reached = plan.estimated_error && *plan.estimated_error <= wanted_;
  for (const ProbeLadder& ladder : ladders_) {
    const double rate = pace_of(scene_.model, plan.settings), least = floor_rate(ladder);
    if (plan.judged_to_the_end() || !ladder.plans(scene_.model, plan.settings) || rate >= least) continue;
    plan.settings = ladder.settings_at(scene_.model, least);
    plan.predicted_seconds *= least / rate;
    plan.why += ", but with no coarser step than usual, as the run could not be judged to its end";
  }
  plan.why = settings_text(plan.settings) + ": " + plan.why;
  plan.reasons = reasons();
  return plan;
}

}  // namespace

Plan quick_plan(const Model& model, const State& start, double duration, const AccuracyTarget& target,
                std::string_view only, const StopTest& stop, std::optional<double> most_seconds) {
  QuickSearch search(model, start, duration, target.kind, wanted_error(target, model, start), only, stop,
                     most_seconds);
  search.run();
  return search.plan();
}

}  // namespace taut
