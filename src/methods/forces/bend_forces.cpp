#include "forces/bend_forces.h"

namespace taut {

BendForces::BendForces(const Model& model, const State& state) : bends_(whole_bends(model, state)) {
  if (!bends_.empty()) inverse_mass_ = model.masses.inverse_mass;
}

void BendForces::kick(double h, const Vectors& position, Vectors& velocity) const {
  for (const Bend& bend : bends_) {
    const BendAngle turn = bend_gradients(bend, position);
    const double impulse = -h * bend.stiffness * (turn.angle - bend.rest);
    for (std::size_t k = 0; k < 3; ++k)
      velocity.add(bend.masses[k], (inverse_mass_[bend.masses[k]] * impulse) * turn.gradient[k]);
  }
}

void BendForces::add_rows(const Vectors& position, std::vector<double>& sum) const {
  for (const Bend& bend : bends_) {
    const BendAngle turn = bend_gradients(bend, position);
    double all = 0.0;
    for (const Vec3& gradient : turn.gradient) all += gradient.norm();
    for (std::size_t k = 0; k < 3; ++k)
      sum[bend.masses[k]] += inverse_mass_[bend.masses[k]] * bend.stiffness * turn.gradient[k].norm() * all;
  }
}

void BendForces::add_product(const Vectors& position, const Vectors& mode, Vectors& product) const {
  for (const Bend& bend : bends_) {
    const BendAngle turn = bend_gradients(bend, position);
    double along = 0.0;
    for (std::size_t k = 0; k < 3; ++k) along += turn.gradient[k].dot(mode.at(bend.masses[k]));
    for (std::size_t k = 0; k < 3; ++k)
      product.add(bend.masses[k],
                  (inverse_mass_[bend.masses[k]] * bend.stiffness * along) * turn.gradient[k]);
  }
}

}  // namespace taut
