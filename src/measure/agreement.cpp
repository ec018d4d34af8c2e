#include "measure/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/failure.h"
#include "measure/cost.h"
#include "measure/method_variants.h"
#include "measure/work_precision.h"
#include "model/measures.h"
#include "model/parts.h"
#include "motion/run.h"
#include "motion/simulate.h"

namespace taut {
namespace {

// Whether halving the step no longer changes anything worth looking at: `enough` of the scene's size.
bool settled(const Opinion& opinion, const Model& model, const State& start, double enough) {
  if (opinion.coarse.size() < opinion.fine.size()) return false;
  const double bound = enough * scene_size(model, start);
  for (std::size_t i = 0; i < opinion.fine.size(); ++i)
    if (!(position_error(opinion.coarse[i], opinion.fine[i]) <= bound)) return false;
  return true;
}

// Passes of an opinion's finer and coarser run. Where something can hit something, what few passes leave of
// an impact is not made good by short steps: the limit of ever shorter steps of one pass each is another
// motion than that of many, and only many agree with a direct solve.
struct Passes {
  int fine = 1, coarse = 1;
};

Passes passes_for(const Model& model) {
  const bool impacts = !model.contacts.empty() || !model.limits.empty();
  return impacts ? Passes{64, 16} : Passes{};
}

// The states at the times; nothing where the run fails, or costs more than so many predicted seconds: how
// much impacts cost can't be foreseen. What it has cost goes into `work`.
std::optional<std::vector<State>> states_within(const Model& model, const State& start,
                                                const Settings& settings, const std::vector<double>& times,
                                                double most_seconds, const StopTest& stop, double& work) {
  Run run(model, start, settings, chart_policy);
  const StopTest enough = [&] {
    stop_if_told(stop);
    return (work = predicted_seconds(model, run)) > most_seconds;
  };
  std::vector<State> states;
  for (const double time : times) {
    const std::optional<State> state = run.at(time, enough);
    if (!state) return std::nullopt;
    states.push_back(run.reported(*state));
  }
  work = predicted_seconds(model, run);
  return states;
}

std::optional<Opinion> opinion_of(const Model& model, const State& start, const MethodVariant& curve,
                                  const std::vector<double>& times, double most_seconds, double enough,
                                  const StopTest& stop) {
  Opinion opinion{curve.name, curve.method, curve.relaxes(), 0.0, {}, {}, {}};
  const Passes passes = passes_for(model);
  const double horizon = times.back();
  double work = 0.0;
  constexpr double patience = 4.0;  // what a run may cost beyond what it should
  for (double rate = 120.0; rate <= 1e6 && 2.0 * work <= most_seconds; rate *= 2.0) {
    const Settings settings = settings_at(model, curve, rate, passes.fine);
    if (predicted_seconds(model, curve.settings.method, rate * horizon, curve.relaxes() ? passes.fine : 1) >
        most_seconds)
      break;
    try {
      std::optional<std::vector<State>> states =
          states_within(model, start, settings, times, patience * most_seconds, stop, work);
      if (!states) continue;
      opinion.coarse = std::move(opinion.fine);
      opinion.fine = *std::move(states);
      opinion.rate = rate;
      opinion.pace = pace_text(settings);
      if (settled(opinion, model, start, enough)) break;
    } catch (const BadRequest&) {
      continue;  // springs too stiff for this step
    }
  }
  if (opinion.coarse.empty()) return std::nullopt;
  if (curve.relaxes() && passes.coarse != passes.fine)
    opinion.coarse = sampled_run(model, start, settings_at(model, curve, 0.5 * opinion.rate, passes.coarse),
                                 times, chart_policy, stop)
                         .states;
  if (opinion.coarse.size() < times.size()) return std::nullopt;
  return opinion;
}

// Two opinions of different methods, the surer one first; twice the same where no other method can do the
// scene.
struct Pair {
  const Opinion *first = nullptr, *second = nullptr;
};

bool one_method_alone(const std::vector<Opinion>& opinions) {
  return std::ranges::all_of(
      opinions, [&](const Opinion& opinion) { return opinion.method == opinions.front().method; });
}

bool may_agree(const Opinion& a, const Opinion& b, bool alone) {
  return a.method < b.method || (alone && &a == &b);
}

std::string names_of(const Pair& pair) {
  if (pair.first == pair.second)
    return fmt::format("{} {} and in steps twice as long agree (no other method can do this scene)",
                       pair.first->name, pair.first->pace);
  return fmt::format("{} {} and {} {} agree{}", pair.first->name, pair.first->pace, pair.second->name,
                     pair.second->pace,
                     pair.first->relaxes && pair.second->relaxes ? " (both relax links one by one)" : "");
}

// How far apart two opinions are, or the two runs of one (m), at a place in the times.
double distance(const Pair& pair, std::size_t place) {
  const auto& [a, b] = pair;
  return std::max({position_error(a->coarse[place], a->fine[place]),
                   position_error(b->coarse[place], b->fine[place]),
                   position_error(a->fine[place], b->fine[place])});
}

std::size_t agreeing(const Pair& pair, double bound) {
  std::size_t count = 0;
  while (count < pair.first->fine.size() && broken_links(pair.first->fine[count]) == 0 &&
         distance(pair, count) <= bound)
    ++count;
  return count;
}

struct AgreedPair {
  Pair pair;
  std::size_t instants = 0;
  double distance = infinity;  // m, the largest up to then
};

// The pair that agrees longest; of those the one that differs least.
AgreedPair best_pair(const std::vector<Opinion>& opinions, double bound) {
  AgreedPair best;
  const bool alone = one_method_alone(opinions);
  for (const Opinion& a : opinions)
    for (const Opinion& b : opinions) {
      if (!may_agree(a, b, alone)) continue;
      AgreedPair found{{&a, &b}, agreeing({&a, &b}, bound), 0.0};
      if (found.instants == 0 || found.instants < best.instants) continue;
      for (std::size_t i = 0; i < found.instants; ++i)
        found.distance = std::max(found.distance, distance(found.pair, i));
      if (found.instants > best.instants || found.distance < best.distance) best = found;
    }
  const std::size_t last = best.instants - 1;
  if (best.instants > 0 && position_error(best.pair.second->coarse[last], best.pair.second->fine[last]) <
                               position_error(best.pair.first->coarse[last], best.pair.first->fine[last]))
    std::swap(best.pair.first, best.pair.second);
  return best;
}

constexpr std::array summary_kinds{ErrorKind::sag, ErrorKind::energy, ErrorKind::strain};

using Summaries = std::vector<Summary>;

// The summaries of an opinion's two runs.
struct Summed {
  const Opinion* opinion = nullptr;
  Summaries coarse, fine;
};

Summaries summaries_of(const Model& model, const std::vector<State>& states) {
  Summaries summaries;
  summaries.reserve(states.size());
  for (const State& state : states) summaries.push_back(summary_of(model, state));
  return summaries;
}

// Compares the summaries of opinions.
class Comparison {
 public:
  Comparison(const Model& model, const State& start) : model_(model), start_(start) {}

  // The largest difference over all times, kind by kind.
  Errors between(const Summaries& a, const Summaries& b) const {
    Errors largest;
    for (const ErrorKind kind : summary_kinds) largest[kind] = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Errors errors = difference(model_, start_, a[i], b[i]);
      for (const ErrorKind kind : summary_kinds) largest[kind] = std::max(*largest[kind], *errors[kind]);
    }
    return largest;
  }

  // The largest of three differences, kind by kind.
  Errors uncertainty(const Summed& a, const Summed& b) const {
    const Errors own = between(a.coarse, a.fine), others = between(b.coarse, b.fine),
                 apart = between(a.fine, b.fine);
    Errors result;
    for (const ErrorKind kind : summary_kinds)
      result[kind] = std::max({*own[kind], *others[kind], *apart[kind]});
    return result;
  }

  // The two of different methods that differ least, the surer one first.
  std::optional<std::pair<Summed, Summed>> best(const std::vector<Summed>& all, bool alone) const {
    std::optional<std::pair<Summed, Summed>> best;
    double least = infinity;
    for (const Summed& a : all)
      for (const Summed& b : all) {
        if (!may_agree(*a.opinion, *b.opinion, alone)) continue;
        const double apart = sum_of(uncertainty(a, b));
        if (!(apart < least)) continue;
        least = apart;
        const bool a_first = sum_of(between(a.coarse, a.fine)) <= sum_of(between(b.coarse, b.fine));
        best = a_first ? std::pair(a, b) : std::pair(b, a);
      }
    return best;
  }

 private:
  static double sum_of(const Errors& errors) { return *errors[ErrorKind::sag] + *errors[ErrorKind::energy]; }

  const Model& model_;
  const State& start_;
};

constexpr double judged_above = 10.0;  // times what two opinions differ by
constexpr double largest_limit = 0.1;  // what is judged no better than this is not judged

void set_limit(Truth& truth, ErrorKind kind, double uncertainty) {
  if (judged_above * uncertainty < largest_limit) truth.smallest[kind] = judged_above * uncertainty;
}

}  // namespace

std::vector<Opinion> opinions_of(const Model& model, const State& start, const std::vector<double>& times,
                                 double most_seconds, double enough, const StopTest& stop) {
  const bool rigid = has_rigid_links(model);
  bool one_of_them = false;
  std::vector<Opinion> opinions;
  for (const MethodVariant& curve : variants_of(model, start).variants) {
    // Without rigid links the methods that know springs as forces are one method, step by step: one will do.
    const bool springs_are_forces = curve.can.limit == StepLimit::sideways_vibration;
    if (!rigid && springs_are_forces && std::exchange(one_of_them, true)) continue;
    if (auto opinion = opinion_of(model, start, curve, times, most_seconds, enough, stop))
      opinions.push_back(*std::move(opinion));
  }
  return opinions;
}

std::optional<Truth> agreed_motion(const Model& model, const State& start,
                                   const std::vector<Opinion>& opinions, double bound) {
  const double size = scene_size(model, start);
  const AgreedPair best = best_pair(opinions, bound * size);
  if (best.instants == 0) return std::nullopt;
  const auto& [first, second] = best.pair;
  const auto agreed = [&](const std::vector<State>& states) {
    return std::span(states).first(best.instants);
  };
  Truth truth;
  truth.states.assign(first->fine.begin(), first->fine.begin() + static_cast<std::ptrdiff_t>(best.instants));
  for (const State& state : truth.states) truth.times.push_back(state.time);
  truth.summaries = summaries_of(model, truth.states);
  for (const ErrorKind kind : all_error_kinds)
    set_limit(truth, kind,
              std::max({error_against(model, start, kind, agreed(first->coarse), agreed(first->fine)),
                        error_against(model, start, kind, agreed(second->coarse), agreed(second->fine)),
                        error_against(model, start, kind, agreed(second->fine), agreed(first->fine))}));
  if (has_rigid_links(model)) truth.smallest[ErrorKind::strain] = exact_length_limit;
  truth.how =
      fmt::format("{}: the motion within {:.1e} of the size", names_of(best.pair), best.distance / size);
  return truth;
}

Truth agreed_summaries(const Model& model, const State& start, const std::vector<Opinion>& opinions,
                       const std::vector<double>& times, const std::string& why) {
  Truth truth;
  truth.times = times;
  truth.remark = why;
  std::vector<Summed> all;
  all.reserve(opinions.size());
  for (const Opinion& opinion : opinions)
    all.push_back({&opinion, summaries_of(model, opinion.coarse), summaries_of(model, opinion.fine)});
  const Comparison comparison(model, start);
  const auto best = comparison.best(all, one_method_alone(opinions));
  if (!best) {
    truth.remark += "; no two methods can be run finely enough to agree";
    return truth;
  }
  const auto& [first, second] = *best;
  truth.summaries = first.fine;
  const Errors uncertainty = comparison.uncertainty(first, second);
  for (const ErrorKind kind : summary_kinds) set_limit(truth, kind, *uncertainty[kind]);
  if (has_rigid_links(model)) truth.smallest[ErrorKind::strain] = exact_length_limit;
  truth.how = fmt::format("{}: sag within {:.1e} of the size, energy within {:.1e}",
                          names_of({first.opinion, second.opinion}), *uncertainty[ErrorKind::sag],
                          *uncertainty[ErrorKind::energy]);
  return truth;
}

}  // namespace taut
