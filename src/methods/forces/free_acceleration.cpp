#include "forces/free_acceleration.h"

#include "forces/forces.h"

namespace taut {

void free_accelerations(const Model& model, const State& whole, const Springs& springs, double time,
                        const Vectors& position, const Vectors& velocity, Vectors& acceleration,
                        std::vector<double>& spring_tension) {
  acceleration.resize(velocity.size());
  fall(model, time, velocity, acceleration);
  // A kick of one second changes a velocity by its acceleration.
  kick_by_springs(springs, 1.0, position, velocity, acceleration, spring_tension);
  add_wind(model, whole, position, velocity, time, acceleration);
  for (const DrivenPin& pin : model.driven_pins)
    acceleration.set(pin.mass, acceleration_at(pin.motion, time));
}

}  // namespace taut
