#include "forces/half_kicks.h"

#include <fmt/format.h>

#include "forces/forces.h"
#include "forces/free_acceleration.h"
#include "methods/frequency.h"

namespace taut {

void HalfKicks::links_changed(const State& state) {
  springs_ = gather_springs(model_, state);
  damped_ = any_damped(springs_);
}

void HalfKicks::start(const State& whole, double time, double half, const Vectors& position,
                      const Vectors& velocity, const Vectors& met, Vectors& kicked) {
  kicked.resize(velocity.size());
  kick(model_, time, half, velocity, kicked, DragAt::start);
  kick_by_springs(springs_, half, position, met, kicked, spring_tension_);
  blow(model_, whole, position, met, time, half, kicked, DragAt::start);
}

void HalfKicks::end(const State& whole, double time, double half, const Vectors& position,
                    const Vectors& kicked, Vectors& velocity, std::vector<double>& tension) {
  if (meet_velocity()) {
    guess_ = velocity;
    for (std::size_t i = 0; i < guess_.size(); ++i)
      if (!model_.masses.pinned(i)) guess_.add(i, (velocity.at(i) - kicked.at(i)) / answered_at_once_);
    kick_by_springs(springs_, half, position, velocity, guess_, spring_tension_);
    blow(model_, whole, position, velocity, time, half, guess_, DragAt::start);
    kick(model_, time, half, guess_, guess_);
    blow(model_, whole, position, guess_, time, half, velocity, DragAt::start);
  }
  kick_by_springs(springs_, half, position, meet_velocity() ? guess_ : velocity, velocity, spring_tension_);
  keep_tensions(tension);
  kick(model_, time, half, velocity, velocity);
}

std::string too_stiff(const Model& model, const State& start, const Settings& settings) {
  // The bound is quick where the frequency itself takes seconds, on a large sheet.
  if (spring_frequency_bound(model, start) < 2.0 * settings.steps_per_second()) return {};
  const double frequency = highest_spring_frequency(model, start);
  if (frequency < 2.0 * settings.steps_per_second()) return {};
  return fmt::format(
      "method {} treats {} as forces, and the stiffest vibrate at {:.4g} rad/s: that needs more than {:.0f} "
      "steps_per_second, or method {}, which takes any stiffness",
      settings.method, model.bends.empty() ? "links with stiffness" : "links with stiffness and bends",
      frequency, 0.5 * frequency, model.bends.empty() ? "newton" : "xpbd");
}

void HalfKicks::accelerations(const State& whole, double time, const Vectors& position,
                              const Vectors& velocity, Vectors& acceleration, std::vector<double>& tension) {
  free_accelerations(model_, whole, springs_, time, position, velocity, acceleration, spring_tension_);
  keep_tensions(tension);
}

void HalfKicks::keep_tensions(std::vector<double>& tension) const {
  for (std::size_t i = 0; i < springs_.links.size(); ++i)
    tension[springs_.links.link[i]] = spring_tension_[i];
}

}  // namespace taut
