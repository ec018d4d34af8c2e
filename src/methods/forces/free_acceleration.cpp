#include "forces/free_acceleration.h"

#include "forces/forces.h"

namespace taut {

void free_accelerations(const Model& model, const State& whole, const Springs& springs, double time,
                        const Vectors& position, const Vectors& velocity, Vectors& acceleration,
                        std::vector<double>& spring_tension) {
  // A kick of one second changes a velocity by its acceleration.
  acceleration = velocity;
  kick(model, time, 1.0, velocity, acceleration, DragAt::start);
  kick_by_springs(springs, 1.0, position, velocity, acceleration, spring_tension);
  for (std::size_t i = 0; i < velocity.size(); ++i) acceleration.add(i, -velocity.at(i));
  add_wind(model, whole, position, velocity, time, acceleration);
  for (const DrivenPin& pin : model.driven_pins)
    acceleration.set(pin.mass, acceleration_at(pin.motion, time));
}

void second_derivatives(const SystemLinks& links, const Vectors& direction, const Vectors& velocity,
                        const Vectors& acceleration, std::vector<double>& result) {
  result.resize(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Index a = links.a[i], b = links.b[i];
    result[i] = direction.at(i).dot(acceleration.at(a) - acceleration.at(b)) +
                (velocity.at(a) - velocity.at(b)).squaredNorm();
  }
}

}  // namespace taut
