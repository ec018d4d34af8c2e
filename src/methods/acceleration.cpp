#include "methods/acceleration.h"

#include "direct/link_system.h"
#include "forces/free_acceleration.h"
#include "forces/springs.h"

namespace taut {
namespace {

std::vector<Index> whole_rigid_links(const Model& model, const State& state) {
  std::vector<Index> links;
  for (const Index link : solvable_links(model))
    if (model.links.rigid(link) && !state.broken(link)) links.push_back(link);
  return links;
}

}  // namespace

struct AccelerationField::Parts {
  const Model& model;
  State whole;  // for what is broken in it
  LinkSystem system;
  Springs springs;
  std::vector<double> no_compliance, multipliers, spring_tension;
  Vectors direction;
};

AccelerationField::AccelerationField(const Model& model, const State& state)
    : parts_(new Parts{model,
                       state,
                       make_link_system(model, whole_rigid_links(model, state)),
                       gather_springs(model, state),
                       {},
                       {},
                       {},
                       {}}) {
  parts_->no_compliance.assign(parts_->system.links.size(), 0.0);
}

AccelerationField::~AccelerationField() = default;
AccelerationField::AccelerationField(AccelerationField&&) noexcept = default;

bool AccelerationField::evaluate(double time, const Vectors& position, const Vectors& velocity,
                                 Vectors& acceleration) {
  Parts& p = *parts_;
  const SystemLinks& links = p.system.links;
  free_accelerations(p.model, p.whole, p.springs, time, position, velocity, acceleration, p.spring_tension);
  link_vectors(links, position, p.direction);
  along_links_moving(links, p.direction, acceleration, velocity, p.multipliers);
  if (!p.system.matrix->factor_and_solve(p.direction, p.direction, p.no_compliance, p.multipliers))
    return false;
  apply_impulses(links, p.direction, p.multipliers, acceleration, -1.0);
  return true;
}

std::vector<double> AccelerationField::tensions() const {
  const Parts& p = *parts_;
  std::vector<double> tensions(p.model.links.size(), 0.0);
  for (std::size_t i = 0; i < p.multipliers.size(); ++i)
    tensions[p.system.links.link[i]] = p.multipliers[i] * p.system.links.length[i];
  for (std::size_t i = 0; i < p.spring_tension.size(); ++i)
    tensions[p.springs.links.link[i]] = p.spring_tension[i];
  return tensions;
}

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
