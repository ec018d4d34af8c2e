#include "contact/ground_contacts.h"

#include "contact/friction.h"

namespace taut {

GroundContacts::GroundContacts(const Model& model) {
  for (const Collider& collider : model.colliders)
    if (const HalfSpace* half_space = as_ground(collider))
      grounds_.push_back({*half_space, collider.friction});
  if (grounds_.empty()) return;
  for (const ContactPoint& point : model.contacts) {
    if (!is_plain(point) || model.masses.pinned(point.masses[0])) continue;
    masses_.push_back(point.masses[0]);
    radius_.push_back(point.radius);
  }
}

bool GroundContacts::solve(const Vectors& start, Vectors& position) const {
  bool touched = false;
  for (const Ground& ground : grounds_) {
    const Vec3 on = ground.half_space.point, normal = ground.half_space.normal;
    for (std::size_t i = 0; i < masses_.size(); ++i) {
      const Index mass = masses_[i];
      const double depth =
          radius_[i] - ((position.x[mass] - on.x()) * normal.x() + (position.y[mass] - on.y()) * normal.y() +
                        (position.z[mass] - on.z()) * normal.z());
      if (!(depth > 0.0)) continue;
      touched = true;
      const Vec3 moved = position.at(mass) - start.at(mass);
      position.add(mass, normal * depth + coulomb_friction(ground.friction, depth, normal, moved));
    }
  }
  return touched;
}

}  // namespace taut
