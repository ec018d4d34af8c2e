#include "measure/events.h"

#include <algorithm>

#include "methods/registry.h"
#include "model/measures.h"
#include "motion/run.h"

namespace taut {
namespace {

constexpr double watching_rate = 960.0;  // steps per second
constexpr std::int64_t interval = 4;     // steps between two looks
constexpr double alike = 1e-9;           // of the scene's size

std::string_view cause(const Model& model, const Model& calm, const State& state) {
  if (calm.breakable_links.empty() && broken_links(state) > 0) return "the first link breaks";
  const bool reached = !limits_angles(calm) && largest_limit_excess(model, state) > 0.0;
  return reached ? "an angle reaches its limit" : "something is touched";
}

// Without anything that can be met, reached or broken.
Model without_events(Model model) {
  std::erase_if(model.limits, [](const Limit& limit) { return limit.kind != LimitKind::reach; });
  model.breakable_links.clear();
  std::ranges::fill(model.links.break_stretch, infinity);
  std::ranges::fill(model.links.break_tension, infinity);
  return model;
}

}  // namespace

bool has_events(const Model& model) {
  return !model.contacts.empty() || !model.limits.empty() || !model.breakable_links.empty();
}

Model without_unlocated_events(const Model& model, const State& start) {
  Model untouched = model;
  untouched.colliders.clear();
  untouched.contacts.clear();
  const bool located = refusals(untouched, start, complete_settings({"dop853", {}})).empty();
  return located ? untouched : without_events(std::move(untouched));
}

std::optional<Event> first_event(const Model& model, const State& start, double horizon,
                                 const StopTest& stop) {
  if (!has_events(model)) return std::nullopt;
  return first_event(model, without_unlocated_events(model, start), start, horizon, stop);
}

std::optional<Event> first_event(const Model& model, const Model& calm, const State& start, double horizon,
                                 const StopTest& stop) {
  if (calm.contacts.size() == model.contacts.size() && calm.limits.size() == model.limits.size() &&
      calm.breakable_links.size() == model.breakable_links.size())
    return std::nullopt;
  const Settings settings =
      complete_settings({"xpbd", {{"steps_per_second", watching_rate}, {"passes", 1.0}}});
  Run run(model, start, settings), calm_run(calm, start, settings);
  const double allowed = alike * scene_size(model, start);
  while (run.state().time < horizon) {
    stop_if_told(stop);
    for (std::int64_t step = 0; step < interval; ++step) {
      run.step();
      calm_run.step();
    }
    // Written so that what is not a number counts as different.
    if (run.ended() || !(position_error(run.state(), calm_run.state()) <= allowed))
      return Event{run.state().time, cause(model, calm, run.state())};
  }
  return std::nullopt;
}

double time_before(const Event& event) {
  return 0.8 * event.time;
}

}  // namespace taut
