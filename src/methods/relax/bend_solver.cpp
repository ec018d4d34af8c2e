#include "relax/bend_solver.h"

#include <algorithm>

namespace taut {

// Bends are built along their lines: of those in a row, every third shares no mass.
void BendSolver::links_changed(const State& state) {
  const std::vector<Bend> whole = whole_bends(model_, state);
  bends_.clear();
  for (const std::size_t first : {0U, 1U, 2U})
    for (std::size_t i = first; i < whole.size(); i += 3) bends_.push_back(whole[i]);
  multipliers_.assign(bends_.size(), 0.0);
}

void BendSolver::begin_step() {
  std::ranges::fill(multipliers_, 0.0);
}

void BendSolver::solve(double h, double answer, Vectors& position) {
  for (std::size_t i = 0; i < bends_.size(); ++i) {
    const Bend& bend = bends_[i];
    const BendAngle turn = bend_gradients(bend, position);
    double weight = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      weight += answer * inverse_mass_[bend.masses[k]] * turn.gradient[k].squaredNorm();
    if (!(weight > 0.0)) continue;  // all its masses are pinned
    const double scaled = 1.0 / (bend.stiffness * h * h);
    const double change = (bend.rest - turn.angle - scaled * multipliers_[i]) / (weight + scaled);
    multipliers_[i] += change;
    for (std::size_t k = 0; k < 3; ++k)
      position.add(bend.masses[k], (answer * inverse_mass_[bend.masses[k]] * change) * turn.gradient[k]);
  }
}

}  // namespace taut
