#include "measure/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/failure.h"
#include "measure/cost.h"
#include "measure/events.h"
#include "measure/explicit_integrator.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "motion/simulate.h"

namespace taut {
namespace {

// Doublings of rattle's steps that bring no agreement at a later time before it is given up.
constexpr int most_in_vain = 2;

bool has_damping(const Model& model) {
  return model.drag > 0.0 || model.wind ||
         std::any_of(model.links.damping.begin(), model.links.damping.end(),
                     [](double c) { return c > 0.0; });
}

// States at the times, each reached exactly by whole steps of at most 1/rate; none where a step can't be
// solved or springs are too stiff for it.
std::vector<State> run_rattle(const Model& model, const State& start, const std::vector<double>& times,
                              double rate, int order, const StopTest& stop) {
  Settings settings{"rattle", {{"order", std::to_string(order)}}};
  std::vector<State> states;
  State state = start;
  try {
    for (const double time : times) {
      stop_if_told(stop);
      const double span = time - state.time;
      const double steps = std::ceil(span * rate * (1.0 - 1e-12));
      if (steps > 0.0) {
        settings.values["steps_per_second"] = std::max(1.0, steps / span);
        const RunReport report = simulate(model, state, settings, static_cast<std::int64_t>(steps), {}, stop);
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

// The motion by an explicit integration at acceleration level, as far as two tolerances agree on it within
// `accuracy`.
struct Integrated {
  std::vector<State> states;
  double distance = 0.0;  // m, between the two
  std::string ending;     // why it does not reach the last time
  bool parted = false;    // because the two no longer agree
  double spent = 0.0;     // of what a run may cost
};

Integrated integrate(const Model& model, const State& start, const std::vector<double>& times,
                     double accuracy, double tolerance, double most_seconds, const StopTest& stop) {
  const auto most_evaluations = static_cast<long>(most_seconds / predicted_seconds(model, "rattle", 1.0, 1));
  ExplicitIntegrator loose(model, start, tolerance), tight(model, start, 0.1 * tolerance);
  Integrated result;
  for (const double time : times) {
    if (!loose.advance_to(time, most_evaluations, stop) || !tight.advance_to(time, most_evaluations, stop)) {
      result.ending = "the equations at acceleration level are singular, or would take too long to integrate";
      break;
    }
    State state = tight.state();
    const double distance = position_error(loose.state(), state);
    if (!(distance <= accuracy)) {
      result.ending =
          fmt::format("the scene is chaotic: at {:.4g} s two tolerances differ by {:.2g} m", time, distance);
      result.parted = true;
      break;
    }
    result.distance = std::max(result.distance, distance);
    result.states.push_back(std::move(state));
  }
  result.spent = static_cast<double>(tight.evaluations()) / static_cast<double>(most_evaluations);
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

// From positions of second order at a step and at its half, better ones (Richardson); none where either is
// missing.
std::vector<State> extrapolated(const std::vector<State>& coarse, const std::vector<State>& fine) {
  std::vector<State> states;
  for (std::size_t i = 0; i < std::min(coarse.size(), fine.size()); ++i) {
    State& state = states.emplace_back(fine[i]);
    for (std::size_t mass = 0; mass < state.position.size(); ++mass)
      state.position.add(mass, (fine[i].position.at(mass) - coarse[i].position.at(mass)) / 3.0);
  }
  return states;
}

// The second opinion: rattle with ever shorter steps, of order 4 where the scene allows it, and else
// extrapolated, until it agrees with the first within half of `accuracy`, or agrees no longer by shorter
// steps, or a run would cost too much.
struct SecondOpinion {
  Agreement agreed;
  double rate = 0.0;  // steps per second
  int order = 4;
};

SecondOpinion second_opinion(const Model& model, const State& start, const std::vector<double>& times,
                             const std::vector<State>& first, double accuracy, double most_seconds,
                             const StopTest& stop) {
  const double span = times.back() - start.time;
  SecondOpinion best;
  best.order = has_damping(model) ? 2 : 4;
  const int sub_steps = best.order == 4 ? 3 : 1;
  std::vector<State> coarse;
  int in_vain = 0;
  for (double rate = 500.0; rate <= 1e7 && in_vain < most_in_vain; rate *= 2.0) {
    if (predicted_seconds(model, "rattle", sub_steps * rate * span, 3) > most_seconds) break;
    std::vector<State> fine = run_rattle(model, start, times, rate, best.order, stop);
    const Agreement agreed = agreement(best.order == 2 ? extrapolated(coarse, fine) : fine, first, accuracy);
    coarse = std::move(fine);
    if (best.agreed.count > 0) in_vain = agreed.count > best.agreed.count ? 0 : in_vain + 1;
    const bool better = agreed.count > best.agreed.count ||
                        (agreed.count == best.agreed.count && agreed.distance < best.agreed.distance);
    if (better) {
      best.agreed = agreed;
      best.rate = rate;
    }
    if (best.agreed.count == first.size() && best.agreed.distance <= 0.5 * accuracy) break;
  }
  return best;
}

// The motion of a scene that has no events.
Reference calm_reference(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy, double most_seconds, const StopTest& stop) {
  const Integrated first = integrate_far(model, start, times, accuracy, most_seconds, stop);
  if (first.states.empty()) return refused(first.ending);
  const std::size_t reached = first.states.size();
  const SecondOpinion second =
      second_opinion(model, start, {times.begin(), times.begin() + static_cast<std::ptrdiff_t>(reached)},
                     first.states, accuracy, most_seconds, stop);
  if (second.agreed.count == 0)
    return refused(fmt::format(
        "at {:.4g} s rattle, as fine as it can be run, does not agree with an integration of the equations "
        "at acceleration level",
        times.front()));
  Reference reference;
  reference.states.assign(first.states.begin(),
                          first.states.begin() + static_cast<std::ptrdiff_t>(second.agreed.count));
  reference.uncertainty = std::max(first.distance, second.agreed.distance);
  reference.certified_until = times[second.agreed.count - 1];
  reference.how = fmt::format(
      "Dormand–Prince 5(4) at acceleration level; rattle of order {} at {:.0f} steps/s{} within {:.1e} m",
      second.order, second.rate, second.order == 2 ? ", extrapolated," : "", reference.uncertainty);
  return reference;
}

}  // namespace

Reference make_reference(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy, double most_seconds, const StopTest& stop) {
  const std::optional<Event> event = first_event(model, start, times.back(), stop);
  if (!event) return calm_reference(without_events(model), start, times, accuracy, most_seconds, stop);
  std::vector<double> calm_times = times;
  std::erase_if(calm_times, [&](double time) { return time > time_before(*event); });
  if (calm_times.empty())
    return refused(
        fmt::format("at {:.3g} s {}, which the reference does not resolve", event->time, event->what));
  return calm_reference(without_events(model), start, calm_times, accuracy, most_seconds, stop);
}

}  // namespace taut
