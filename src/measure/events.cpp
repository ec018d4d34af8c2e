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

std::string_view cause(const Model& model, const State& state) {
  if (broken_links(state) > 0) return "the first link breaks";
  return largest_limit_excess(model, state) > 0.0 ? "an angle reaches its limit" : "something is touched";
}

}  // namespace

bool has_events(const Model& model) {
  return !model.contacts.empty() || !model.limits.empty() || !model.breakable_links.empty();
}

Model without_events(const Model& model) {
  Model calm = model;
  calm.colliders.clear();
  calm.contacts.clear();
  calm.limits.clear();
  calm.breakable_links.clear();
  std::ranges::fill(calm.links.break_stretch, infinity);
  std::ranges::fill(calm.links.break_tension, infinity);
  return calm;
}

std::optional<Event> first_event(const Model& model, const State& start, double horizon,
                                 const StopTest& stop) {
  if (!has_events(model)) return std::nullopt;
  const Model calm = without_events(model);
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
      return Event{run.state().time, cause(model, run.state())};
  }
  return std::nullopt;
}

double time_before(const Event& event) {
  return 0.8 * event.time;
}

}  // namespace taut
