#include "energy_guard.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/measures.h"

namespace taut {
namespace {

constexpr double allowed = 0.1;  // of the scene's energies

}  // namespace

EnergyGuard::EnergyGuard(const Model& model, const State& start) : model_(&model), mass_(free_mass(model)) {
  double loads = 0.0;
  for (const Load& load : model.loads) loads += load.force.norm() * static_cast<double>(load.masses.size());
  scale_ = energy_scale(model, start) + loads * total_link_length(model);
  for (const Joint& joint : model.joints) scale_ += joint.friction;  // through a radian
  gather_springs_of(model);
  energy_at_start_ = energy_of(start);
}

void EnergyGuard::gather_springs_of(const Model& model) {
  springs_.clear();
  for (const Index link : links_with_a_free_end(model))
    if (!model.links.rigid(link)) springs_.push_back(link);
}

void EnergyGuard::go_on_with(const Model& model) {
  model_ = &model;
  mass_ = free_mass(model);
  gather_springs_of(model);
}

// But for that of links between pins, which rigid links have no part in.
double EnergyGuard::energy_of(const State& state) const {
  double sum = energy_of_masses(*model_, state).total();
  for (const Index link : springs_) sum += elastic_energy(*model_, state, link);
  return sum;
}

bool EnergyGuard::exceeded(Stepper& stepper, double h, const Work& work) {
  const double scale = scale_ + mass_ * work.fastest_pin * work.fastest_pin + work.throughput;
  double most = allowed * scale;
  if (model_->wind) most = scale + mass_ * wind_at(*model_->wind, stepper.glimpse().time).squaredNorm();
  const std::optional<double> known = stepper.energy();
  const double energy = known ? *known : energy_of(stepper.store());
  const double gain = energy - energy_at_start_ - work.expected_gain();
  // Written so that what is not a number exceeds; the swing costs more and is asked for last.
  return !(gain <= most) && !(gain <= most + swing(stepper.store(), h));
}

// (h²/8) Σ w |F|²
double EnergyGuard::swing(const State& state, double h) {
  if (springs_.empty()) return 0.0;
  force_.resize(state.position.size());
  for (std::size_t i = 0; i < force_.size(); ++i) force_.set(i, model_->masses.mass[i] * model_->gravity);
  for (const Load& load : model_->loads)
    for (const Index mass : load.masses) force_.add(mass, load.share(state.time) * load.force);
  for (const Index link : springs_) {
    if (state.broken(link)) continue;
    const Index a = model_->links.a[link], b = model_->links.b[link];
    const Vec3 difference = state.position.at(a) - state.position.at(b);
    const double distance = difference.norm();
    if (distance == 0.0) continue;
    const Vec3 pull =
        (model_->links.stiffness[link] * model_->links.stretch(link, distance) / distance) * difference;
    force_.add(a, -pull);
    force_.add(b, pull);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < force_.size(); ++i)
    sum += model_->masses.inverse_mass[i] * force_.at(i).squaredNorm();
  return 0.125 * h * h * sum;
}

}  // namespace taut
