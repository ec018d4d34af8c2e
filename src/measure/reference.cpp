#include "measure/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/failure.h"
#include "measure/events.h"
#include "measure/explicit_integrator.h"
#include "measure/measures.h"
#include "methods/registry.h"
#include "methods/simulate.h"

namespace taut {
namespace {

// What an opinion may cost: evaluations times links. A chain's takes seconds, a net's a minute.
constexpr double most_link_evaluations = 5e7;

double link_count(const Model& model) {
  return static_cast<double>(std::max<std::size_t>(20, model.links.size()));
}

bool has_damping(const Model& model) {
  return model.drag > 0.0 || std::any_of(model.links.damping.begin(), model.links.damping.end(),
                                         [](double c) { return c > 0.0; });
}

// States at the times, each reached exactly by whole steps of at most 1/rate; empty where a step can't be
// solved.
std::optional<std::vector<State>> run_rattle(const Model& model, const State& start,
                                             const std::vector<double>& times, double rate, int order) {
  Settings settings{"rattle", {{"order", std::to_string(order)}}};
  std::vector<State> states;
  State state = start;
  for (const double time : times) {
    const double span = time - state.time;
    const double steps = std::ceil(span * rate * (1.0 - 1e-12));
    if (steps > 0.0) {
      settings.values["steps_per_second"] = std::max(1.0, steps / span);
      const StepReport report = simulate(model, state, settings, static_cast<std::int64_t>(steps));
      if (report.status != StepStatus::done) return std::nullopt;
      state.time = time;
    }
    states.push_back(state);
  }
  return states;
}

double largest_difference(const std::vector<State>& a, const std::vector<State>& b, std::size_t count) {
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, position_error(a[i], b[i]));
  return largest;
}

// How many of the first states agree within a bound.
std::size_t agreeing(const std::vector<State>& a, const std::vector<State>& b, double bound) {
  std::size_t count = 0;
  while (count < std::min(a.size(), b.size()) && position_error(a[count], b[count]) <= bound) ++count;
  return count;
}

// The last two of a row of runs with halved steps, and the rate of the finer.
struct Halved {
  std::vector<State> coarse, fine;
  double rate = 0.0;
};

// Halves the step until that changes nothing by more than `bound`, or a run would cost too much.
Halved halve_steps(const Model& model, const State& start, const std::vector<double>& times, int order,
                   double bound) {
  const double most_steps = most_link_evaluations / link_count(model);
  const double span = times.back() - start.time;
  Halved halved;
  for (double rate = 500.0; halved.fine.empty() || rate * span <= most_steps; rate *= 2.0) {
    if (rate > 1e7) break;
    std::optional<std::vector<State>> states;
    try {
      states = run_rattle(model, start, times, rate, order);
    } catch (const BadRequest&) {
      continue;  // springs too stiff for this step
    }
    if (!states) continue;
    halved.coarse = std::move(halved.fine);
    halved.fine = std::move(*states);
    halved.rate = rate;
    if (!halved.coarse.empty() && largest_difference(halved.coarse, halved.fine, times.size()) <= bound)
      break;
  }
  if (halved.coarse.empty()) halved.fine.clear();
  return halved;
}

Reference refused(std::string reason) {
  Reference reference;
  reference.refusal = std::move(reason);
  return reference;
}

// The motion of a scene that has no events.
Reference calm_reference(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy) {
  // The second opinion comes first: where it does not even agree with itself, halving steps would be in vain.
  const auto most_evaluations = static_cast<long>(most_link_evaluations / link_count(model));
  const auto loose = integrate_explicitly(model, start, times, accuracy * 1e-3, most_evaluations);
  const auto tight = integrate_explicitly(model, start, times, accuracy * 1e-4, most_evaluations);
  if (loose.empty() || tight.empty())
    return refused(
        "the equations at acceleration level are singular, or would take too long to integrate, so there is "
        "no "
        "second opinion");
  std::size_t count = agreeing(loose, tight, accuracy);
  if (count == 0)
    return refused(fmt::format("the scene is chaotic: at {:.4g} s two tolerances differ by {:.2g} m",
                               times.front(), position_error(loose.front(), tight.front())));

  const int order = has_damping(model) ? 2 : 4;
  const Halved halved =
      halve_steps(model, start, {times.begin(), times.begin() + static_cast<std::ptrdiff_t>(count)}, order,
                  accuracy / 3.0);
  if (halved.fine.empty()) return refused("rattle can't solve the scene's steps at two step sizes");
  count =
      std::min(agreeing(halved.fine, tight, accuracy), agreeing(halved.coarse, halved.fine, accuracy / 3.0));
  if (count == 0)
    return refused(
        fmt::format("at {:.4g} s halving the step changes the result by {:.2g} m, and the second opinion is "
                    "{:.2g} m away",
                    times.front(), position_error(halved.coarse.front(), halved.fine.front()),
                    position_error(halved.fine.front(), tight.front())));
  Reference reference;
  reference.states.assign(halved.fine.begin(), halved.fine.begin() + static_cast<std::ptrdiff_t>(count));
  reference.uncertainty = std::max(largest_difference(halved.fine, tight, count),
                                   largest_difference(halved.coarse, halved.fine, count));
  reference.certified_until = times[count - 1];
  reference.how = fmt::format(
      "rattle of order {} at {:.0f} steps/s; Dormand–Prince 5(4) at acceleration level within {:.1e} m",
      order, halved.rate, reference.uncertainty);
  return reference;
}

}  // namespace

Reference make_reference(const Model& model, const State& start, const std::vector<double>& times,
                         double accuracy) {
  const std::optional<Event> event = first_event(model, start, times.back());
  if (!event) return calm_reference(without_events(model), start, times, accuracy);
  std::vector<double> calm_times = times;
  std::erase_if(calm_times, [&](double time) { return time > time_before(*event); });
  if (calm_times.empty())
    return refused(
        fmt::format("at {:.3g} s {}, which the reference does not resolve", event->time, event->what));
  return calm_reference(without_events(model), start, calm_times, accuracy);
}

}  // namespace taut
