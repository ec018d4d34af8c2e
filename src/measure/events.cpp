#include "measure/events.h"

#include <algorithm>

#include "methods/registry.h"
#include "model/measures.h"
#include "motion/advance.h"

namespace taut {
namespace {

constexpr double rate = 960.0;        // steps per second
constexpr std::int64_t interval = 4;  // steps between two looks
constexpr double alike = 1e-9;        // of the scene's size

bool has_events(const Model& model) {
  return !model.contacts.empty() || !model.limits.empty() || !model.breakable_links.empty();
}

std::string_view cause(const Model& model, const State& state) {
  if (broken_links(state) > 0) return "the first link breaks";
  return largest_limit_excess(model, state) > 0.0 ? "an angle reaches its limit" : "something is touched";
}

}  // namespace

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

std::optional<Event> first_event(const Model& model, const State& start, double horizon) {
  if (!has_events(model)) return std::nullopt;
  const Model calm = without_events(model);
  const Settings settings = complete_settings({"xpbd", {{"steps_per_second", rate}, {"passes", 1.0}}});
  const Method& method = *find_method(settings.method);
  const auto stepper = method.make(model, settings), calm_stepper = method.make(calm, settings);
  stepper->links_changed(start);
  calm_stepper->links_changed(start);
  const double allowed = alike * scene_size(model, start);
  State state = start, calm_state = start;
  for (std::int64_t step = 1; static_cast<double>(step - 1) / rate < horizon; ++step) {
    advance(*stepper, model, state, 1.0 / rate);
    advance(*calm_stepper, calm, calm_state, 1.0 / rate);
    state.time = calm_state.time = static_cast<double>(step) / rate;
    // Written so that what is not a number counts as different.
    if (step % interval == 0 && !(position_error(state, calm_state) <= allowed))
      return Event{state.time, cause(model, state)};
  }
  return std::nullopt;
}

double time_before(const Event& event) {
  return 0.8 * event.time;
}

}  // namespace taut
