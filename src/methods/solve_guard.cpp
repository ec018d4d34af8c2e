#include "solve_guard.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace taut {

double length_tolerance(const SystemLinks& links, const Vectors& position) {
  double farthest = 0.0;
  for (const auto* axis : {&position.x, &position.y, &position.z})
    for (const double value : *axis) farthest = std::max(farthest, std::abs(value));
  const double shortest =
      links.size() == 0 ? 1.0 : *std::min_element(links.length.begin(), links.length.end());
  return std::max(1e-12, 16.0 * std::numeric_limits<double>::epsilon() * farthest / shortest);
}

EnergyWatch::EnergyWatch(const Model& model)
    : model_(model), mass_(free_mass(model)), driven_(model.masses.size(), false) {
  double force = mass_ * model.gravity.norm();
  for (const Load& load : model.loads) force += load.force.norm() * static_cast<double>(load.masses.size());
  force_scale_ = force * total_link_length(model);
  for (const Joint& joint : model.joints) force_scale_ += joint.friction;  // through a radian
  for (const DrivenPin& pin : model.driven_pins) driven_[pin.mass] = true;
  for (const Index link : solvable_links(model)) {
    if (!model.links.rigid(link)) springs_.push_back(link);
    if (driven_[model.links.a[link]] || driven_[model.links.b[link]]) driven_links_.push_back(link);
  }
}

double EnergyWatch::elastic(const State& state, const Vectors& position) const {
  double sum = 0.0;
  for (const Index link : springs_) {
    if (state.broken(link)) continue;
    const double stretch = link_distance(model_, position, link) - model_.links.length[link];
    sum += 0.5 * model_.links.stiffness[link] * stretch * stretch;
  }
  return sum;
}

// Work of driven pins: the pull of their links, as large as at the end of the step, along the way of the pin.
double EnergyWatch::pin_work(const State& before, const Vectors& position,
                             const std::vector<double>& tension) const {
  double work = 0.0;
  for (const Index link : driven_links_) {
    if (before.broken(link)) continue;
    const Index a = model_.links.a[link], b = model_.links.b[link];
    const Vec3 difference = position.at(a) - position.at(b);
    const Vec3 pull = difference * (tension[link] / difference.norm());
    if (driven_[a]) work += pull.dot(position.at(a) - before.position.at(a));
    if (driven_[b]) work -= pull.dot(position.at(b) - before.position.at(b));
  }
  return work;
}

bool EnergyWatch::jumped(const State& before, const Vectors& position, const Vectors& velocity,
                         const std::vector<double>& tension, double h) const {
  double kinetic_before = 0.0, kinetic = 0.0, falling = 0.0;
  const Vec3 g = model_.gravity;
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (model_.masses.pinned(i)) continue;
    const double mass = model_.masses.mass[i];
    const auto squared = [](const Vectors& v, std::size_t k) {
      return v.x[k] * v.x[k] + v.y[k] * v.y[k] + v.z[k] * v.z[k];
    };
    kinetic_before += 0.5 * mass * squared(before.velocity, i);
    kinetic += 0.5 * mass * squared(velocity, i);
    falling += mass * (g.x() * (position.x[i] - before.position.x[i]) +
                       g.y() * (position.y[i] - before.position.y[i]) +
                       g.z() * (position.z[i] - before.position.z[i]));
  }
  double gain = kinetic - kinetic_before - falling;
  const double elastic_before = elastic(before, before.position);
  gain += elastic(before, position) - elastic_before;
  for (const Load& load : model_.loads) {
    const Vec3 force = load.force * load.share(before.time + 0.5 * h);
    for (const Index mass : load.masses)
      if (!model_.masses.pinned(mass)) gain -= force.dot(position.at(mass) - before.position.at(mass));
  }
  gain -= pin_work(before, position, tension);
  double pin_speed_squared = 0.0;
  for (const DrivenPin& pin : model_.driven_pins)
    pin_speed_squared = std::max(pin_speed_squared, velocity.at(pin.mass).squaredNorm());
  // The wind may take a feather along at once.
  if (model_.wind) gain -= mass_ * wind_at(*model_.wind, before.time + h).squaredNorm();
  return !(gain <= 0.1 * (force_scale_ + kinetic_before + elastic_before + mass_ * pin_speed_squared));
}

void EnergyWatch::take_over(State& state, Vectors& position, Vectors& velocity, std::vector<double>& tension,
                            double h, StepReport& report) const {
  if (!std::isfinite(state.time + h) || !all_finite(position) || !all_finite(velocity)) {
    report.status = StepStatus::not_finite;
    return;
  }
  if (on_ && jumped(state, position, velocity, tension, h)) {
    report.status = StepStatus::energy_jump;
    return;
  }
  std::swap(state.position, position);
  std::swap(state.velocity, velocity);
  std::swap(state.tension, tension);
  state.time += h;
}

}  // namespace taut
