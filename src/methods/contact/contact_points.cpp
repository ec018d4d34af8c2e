#include "contact/contact_points.h"

namespace taut {

ContactPoints::ContactPoints(const Model& model) : model_(model) {
  for (const ContactPoint& point : model.contacts) {
    double weight = 0.0;
    for (std::size_t k = 0; k < point.masses.size(); ++k)
      weight += model.masses.inverse_mass[point.masses[k]] * point.weights[k] * point.weights[k];
    weight_.push_back(weight);
    any_static_friction_ = any_static_friction_ || point.static_friction;
  }
}

void ContactPoints::move(std::uint32_t i, const Vec3& way, Vectors& of) const {
  if (weight_[i] == 0.0) return;
  const ContactPoint& point = model_.contacts[i];
  for (std::size_t k = 0; k < point.masses.size(); ++k)
    if (point.weights[k] != 0.0)
      of.add(point.masses[k],
             (model_.masses.inverse_mass[point.masses[k]] * point.weights[k] / weight_[i]) * way);
}

}  // namespace taut
