#include "fastest_solid.h"

#include <algorithm>
#include <cmath>

#include "model/solid_mesh.h"

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

// How far (m) from what it turns about a solid's surface reaches where masses can be.
class Reach {
 public:
  Reach(const Model& model, const State& start, const Vec3& about)
      : model_(model), start_(start), about_(about) {}

  double operator()(const Sphere& sphere) const { return (sphere.centre - about_).norm() + sphere.radius; }
  double operator()(const Capsule& capsule) const {
    return std::max((capsule.a - about_).norm(), (capsule.b - about_).norm()) + capsule.radius;
  }
  double operator()(const Box& box) const { return (box.centre - about_).norm() + box.half_size.norm(); }
  double operator()(const MeshSolid& solid) const {
    const Bounds& own = solid.mesh->bounds();
    return (solid.place(0.5 * (own.low + own.high)) - about_).norm() + 0.5 * (own.high - own.low).norm();
  }
  // A plane has no end: as far as masses are, and their links.
  double operator()(const HalfSpace& /*plane*/) const {
    double farthest = 0.0;
    for (std::size_t i = 0; i < start_.position.size(); ++i)
      farthest = std::max(farthest, (start_.position.at(i) - about_).norm());
    return farthest + total_link_length(model_);
  }

 private:
  const Model& model_;
  const State& start_;
  Vec3 about_;
};

}  // namespace

double fastest_solid(const Model& model, const State& start) {
  const auto speed = [](const auto& part) { return fastest(part); };
  double most = 0.0;
  for (const Collider& collider : model.colliders) {
    if (!collider.motion) continue;
    const SolidMotion& motion = *collider.motion;
    const double turning = std::visit(speed, motion.turn);
    const double reach = turning > 0.0 ? std::visit(Reach(model, start, motion.centre), collider.shape) : 0.0;
    most = std::max(most, std::visit(speed, motion.way) + reach * turning);
  }
  return most;
}

}  // namespace taut
