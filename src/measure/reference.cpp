#include "measure/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/failure.h"
#include "base/vector_operations.h"
#include "measure/cost.h"
#include "measure/events.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "motion/run.h"
#include "motion/simulate.h"

namespace taut {
namespace {

// Doublings of rattle's steps that bring no agreement at a later time before it is given up.
constexpr int most_in_vain = 2;

Settings rattle_of_order(int order, double rate) {
  return complete_settings({"rattle", {{"order", std::to_string(order)}, {"steps_per_second", rate}}});
}

// States at the times, each reached exactly by whole steps of at most 1/rate; none where a step can't be
// solved or springs are too stiff for it.
std::vector<State> run_rattle(const Model& model, const State& start, const std::vector<double>& times,
                              double rate, int order, const StopTest& stop) {
  constexpr RunPolicy policy{.cut_at_stops = true};
  std::vector<State> states;
  State state = start;
  try {
    for (const double time : times) {
      stop_if_told(stop);
      const double span = time - state.time;
      const double steps = std::ceil(span * rate * (1.0 - 1e-12));
      if (steps > 0.0) {
        const RunReport report = simulate(model, state, rattle_of_order(order, std::max(1.0, steps / span)),
                                          static_cast<std::int64_t>(steps), policy, stop);
        if (report.end != RunEnd::none) return {};
        state.time = time;
      }
      states.push_back(state);
    }
  } catch (const BadRequest&) {
    return {};
  }
  return states;
}

// How many of the first states agree within a bound, and by how much the worst of those differ.
struct Agreement {
  std::size_t count = 0;
  double distance = 0.0;  // m
};

Agreement agreement(const std::vector<State>& a, const std::vector<State>& b, double bound) {
  Agreement found;
  while (found.count < std::min(a.size(), b.size())) {
    const double distance = position_error(a[found.count], b[found.count]);
    if (!(distance <= bound)) break;
    found.distance = std::max(found.distance, distance);
    ++found.count;
  }
  return found;
}

Reference refused(std::string reason) {
  Reference reference;
  reference.refusal = std::move(reason);
  return reference;
}

// The motion by dop853, as far as two tolerances agree on it within `accuracy`.
struct Integrated {
  std::vector<State> states;
  double distance = 0.0;   // m, between the two
  double tolerance = 0.0;  // m, the tighter one
  std::string ending;      // why it does not reach the last time
  bool parted = false;     // because the two no longer agree
  double spent = 0.0;      // of what a run may cost
};

// The smallest tolerance that positions can be told apart by (m).
double least_tolerance(const State& start) {
  return std::max(1e-14, 8.0 * std::numeric_limits<double>::epsilon() * largest_coordinate(start.position));
}

Integrated integrate(const Model& model, const State& start, const std::vector<double>& times,
                     double accuracy, double tolerance, double most_seconds, const StopTest& stop) {
  Integrated result;
  result.tolerance = std::max(tolerance, least_tolerance(start));
  const auto within = [](double metres) { return complete_settings({"dop853", {{"tolerance", metres}}}); };
  Run loose(model, start, within(10.0 * result.tolerance)), tight(model, start, within(result.tolerance));
  const StopTest enough = [&] {
    stop_if_told(stop);
    return predicted_seconds(model, tight) > most_seconds;
  };
  for (const double time : times) {
    const std::optional<State> other = loose.at(time, enough), state = tight.at(time, enough);
    if (!other || !state) {
      const std::string failure = tight.failure() + loose.failure();
      result.ending = failure.empty() ? "the integration by dop853 would take too long" : failure;
      break;
    }
    const double distance = position_error(*other, *state);
    if (!(distance <= accuracy)) {
      result.ending =
          fmt::format("the scene is chaotic: at {:.4g} s two tolerances differ by {:.2g} m", time, distance);
      result.parted = true;
      break;
    }
    result.distance = std::max(result.distance, distance);
    result.states.push_back(*state);
  }
  result.spent = predicted_seconds(model, tight) / most_seconds;
  return result;
}

// The same with tolerances as loose as they may be: where those part early, and cost little, with tighter
// ones.
Integrated integrate_far(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy, double most_seconds, const StopTest& stop) {
  Integrated best;
  for (const double share : {1e-3, 1e-5}) {
    Integrated found = integrate(model, start, times, accuracy, share * accuracy, most_seconds, stop);
    const bool worth_more = found.parted && found.spent < 0.05;
    if (best.ending.empty() || found.states.size() > best.states.size()) best = std::move(found);
    if (!worth_more) break;
  }
  return best;
}

// From positions at a step and at its half, of a method whose error falls with a power of the step, better
// ones (Richardson); none where either is missing.
std::vector<State> extrapolated(const std::vector<State>& coarse, const std::vector<State>& fine, int order) {
  std::vector<State> states;
  for (std::size_t i = 0; i < std::min(coarse.size(), fine.size()); ++i) {
    State& state = states.emplace_back(fine[i]);
    for (std::size_t mass = 0; mass < state.position.size(); ++mass)
      state.position.add(
          mass, (fine[i].position.at(mass) - coarse[i].position.at(mass)) / (std::exp2(order) - 1.0));
  }
  return states;
}

// The second opinion: rattle with ever shorter steps, of order 4 where the scene allows it, until it agrees
// with the first within half of `accuracy`, or agrees no longer by shorter steps, or a run would cost too
// much. Each run counts as it is and extrapolated from the one before, which is worth two orders where
// nothing breaks and no stop is met.
struct SecondOpinion {
  Agreement agreed;
  double rate = 0.0;  // steps per second
  int order = 4;
  bool extrapolated = false;
};

SecondOpinion second_opinion(const Model& model, const State& start, const std::vector<double>& times,
                             const std::vector<State>& first, double accuracy, double most_seconds,
                             const StopTest& stop) {
  const double span = times.back() - start.time;
  SecondOpinion best;
  constexpr double finest = 1e7;
  best.order = refusals(model, start, rattle_of_order(4, finest)).empty() ? 4 : 2;
  const int sub_steps = best.order == 4 ? 3 : 1;
  std::vector<State> coarse;
  int in_vain = 0;
  for (double rate = 500.0; rate <= finest && in_vain < most_in_vain; rate *= 2.0) {
    if (predicted_seconds(model, "rattle", sub_steps * rate * span, 3) > most_seconds) break;
    std::vector<State> fine = run_rattle(model, start, times, rate, best.order, stop);
    const std::size_t before = best.agreed.count;
    const auto offer = [&](const std::vector<State>& states, bool is_extrapolated) {
      const Agreement agreed = agreement(states, first, accuracy);
      if (agreed.count < best.agreed.count ||
          (agreed.count == best.agreed.count && agreed.distance >= best.agreed.distance))
        return;
      best.agreed = agreed;
      best.rate = rate;
      best.extrapolated = is_extrapolated;
    };
    offer(fine, false);
    offer(extrapolated(coarse, fine, best.order), true);
    coarse = std::move(fine);
    if (before > 0) in_vain = best.agreed.count > before ? 0 : in_vain + 1;
    if (best.agreed.count == first.size() && best.agreed.distance <= 0.5 * accuracy) break;
  }
  return best;
}

// The motion of a scene all of whose events dop853 locates.
Reference calm_reference(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy, double most_seconds, const StopTest& stop) {
  const Integrated first = integrate_far(model, start, times, accuracy, most_seconds, stop);
  if (first.states.empty()) return refused(first.ending);
  const std::size_t reached = first.states.size();
  const SecondOpinion second =
      second_opinion(model, start, {times.begin(), times.begin() + static_cast<std::ptrdiff_t>(reached)},
                     first.states, accuracy, most_seconds, stop);
  if (second.agreed.count == 0)
    return refused(fmt::format("at {:.4g} s rattle, as fine as it can be run, does not agree with dop853",
                               times.front()));
  Reference reference;
  reference.states.assign(first.states.begin(),
                          first.states.begin() + static_cast<std::ptrdiff_t>(second.agreed.count));
  reference.uncertainty = std::max(first.distance, second.agreed.distance);
  reference.certified_until = times[second.agreed.count - 1];
  reference.how = fmt::format(
      "two kinds: dop853 within {:.0e} m a step, and rattle of order {} at {:.0f} steps/s{}, agree within "
      "{:.1e} m",
      first.tolerance, second.order, second.rate, second.extrapolated ? ", extrapolated" : "",
      reference.uncertainty);
  return reference;
}

}  // namespace

Reference make_reference(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy, double most_seconds, const StopTest& stop) {
  const Model calm = without_unlocated_events(model, start);
  const std::optional<Event> event = first_event(model, calm, start, times.back(), stop);
  if (const auto problems = refusals(calm, start, complete_settings({"dop853", {}})); !problems.empty())
    return refused(problems.front());
  if (!event) return calm_reference(calm, start, times, accuracy, most_seconds, stop);
  std::vector<double> calm_times = times;
  std::erase_if(calm_times, [&](double time) { return time > time_before(*event); });
  if (calm_times.empty())
    return refused(
        fmt::format("at {:.3g} s {}, which the reference does not resolve", event->time, event->what));
  return calm_reference(calm, start, calm_times, accuracy, most_seconds, stop);
}

}  // namespace taut
