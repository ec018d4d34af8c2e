#include "methods/projected_velocities.h"

#include "direct/link_system.h"

namespace taut {

Vectors projected_velocities(const Model& model, const State& state) {
  LinkSystem system = make_link_system(model, whole_rigid_links(model, state));
  Vectors direction;
  link_vectors(system.links, state.position, direction);
  const std::vector<double> no_compliance(system.links.size(), 0.0);
  std::vector<double> impulse;
  along_links(system.links, direction, state.velocity, impulse);
  if (!system.matrix->factor_and_solve(direction, direction, no_compliance, impulse)) return state.velocity;
  Vectors projected = state.velocity;
  apply_impulses(system.links, direction, impulse, projected, -1.0);
  return projected;
}

}  // namespace taut
