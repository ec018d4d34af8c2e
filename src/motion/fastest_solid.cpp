#include "fastest_solid.h"

#include <algorithm>
#include <cmath>

#include "model/measures.h"

namespace taut {
namespace {

constexpr int looks_a_segment = 16;  // of a path, at its speed
constexpr double beyond_looks = 1.1;

double fastest(std::monostate) {
  return 0.0;
}
double fastest(const SteadyTurn& turn) {
  return std::abs(turn.rate);
}
double fastest(const Sinusoid& way) {
  return way.amplitude.norm() * std::abs(way.angular_frequency);
}
double fastest(const Path& way) {
  double most = 0.0;
  for (std::size_t i = 1; i < way.knots.size(); ++i)
    for (int look = 0; look <= looks_a_segment; ++look)
      most = std::max(most, velocity_at(way, std::lerp(way.knots[i - 1].time, way.knots[i].time,
                                                       static_cast<double>(look) / looks_a_segment))
                                .norm());
  return beyond_looks * most;
}

// How far from what it turns about a solid reaches.
double reach(const Sphere& sphere, const Vec3& about, double /*scene*/) {
  return (sphere.centre - about).norm() + sphere.radius;
}
double reach(const Capsule& capsule, const Vec3& about, double /*scene*/) {
  return std::max((capsule.a - about).norm(), (capsule.b - about).norm()) + capsule.radius;
}
double reach(const Box& box, const Vec3& about, double /*scene*/) {
  return (box.centre - about).norm() + box.half_size.norm();
}
// A plane has no end: as far as masses are, and their links.
double reach(const HalfSpace& /*plane*/, const Vec3& /*about*/, double scene) {
  return scene;
}

}  // namespace

double fastest_solid(const Model& model, const State& start) {
  const double links = total_link_length(model);
  double most = 0.0;
  for (const Collider& collider : model.colliders) {
    if (!collider.motion) continue;
    const SolidMotion& motion = *collider.motion;
    double masses = links;
    for (std::size_t i = 0; i < start.position.size(); ++i)
      masses = std::max(masses, (start.position.at(i) - motion.centre).norm() + links);
    const double arm =
        std::visit([&](const auto& shape) { return reach(shape, motion.centre, masses); }, collider.shape);
    const auto speed = [](const auto& part) { return fastest(part); };
    most = std::max(most, std::visit(speed, motion.way) + arm * std::visit(speed, motion.turn));
  }
  return most;
}

}  // namespace taut
