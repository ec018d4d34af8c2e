#include "relax/limit_solver.h"

#include <algorithm>

namespace taut {

LimitSolver::LimitSolver(const Model& model)
    : limits_(model.limits), inverse_mass_(model.masses.inverse_mass), pushes_(model.limits.size()) {}

void LimitSolver::begin_step() {
  std::fill(pushes_.begin(), pushes_.end(), Push{});
  pushed_ = false;
}

void LimitSolver::solve_along(const Vectors& start, Vectors& position, double h, double answer) {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const Limit& limit = limits_[i];
    Push& push = pushes_[i];
    const double now = limit_angle(limit, position);
    Overshoot beyond = overshoot(limit, now);
    // What pushes at one end is first taken back there before the other end may push.
    if (beyond.sign != push.sign && push.multiplier < 0.0)
      beyond = {excess_at(limit, now, push.sign), push.sign};
    push.sign = beyond.sign;
    if (beyond.size <= 0.0 && push.multiplier == 0.0) continue;
    pushed_ = true;
    const LimitAngle angle = limit_gradients(limit, position);
    const LimitAngle along = &start == &position ? angle : limit_gradients(limit, start);
    double weight = 0.0;
    for (std::size_t k = 0; k < limit.count; ++k)
      weight += answer * inverse_mass_[limit.masses[k]] * angle.gradient[k].dot(along.gradient[k]);
    if (!(weight > 0.0)) continue;  // all its masses are pinned, or the direction is lost
    const double scaled = limit.compliance / (h * h);
    const double wanted = (-beyond.size - scaled * push.multiplier) / (weight + scaled);
    const double change = std::min(push.multiplier + wanted, 0.0) - push.multiplier;
    push.multiplier += change;
    for (std::size_t k = 0; k < limit.count; ++k) {
      const Index mass = limit.masses[k];
      position.add(mass, (answer * inverse_mass_[mass] * change * beyond.sign) * along.gradient[k]);
    }
  }
}

}  // namespace taut
