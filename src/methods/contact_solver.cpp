#include "contact_solver.h"

#include <algorithm>

namespace taut {
namespace {

constexpr double margin = 0.02;  // m, that links may push something within a step

}  // namespace

ContactSolver::ContactSolver(const Model& model) : model_(model), points_(model) {}

void ContactSolver::begin_step(const Vectors& start, const Vectors& velocity, const Vectors& predicted) {
  start_ = &start;
  start_velocity_ = &velocity;
  near_.clear();
  touches_.clear();
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    if (points_.weight(i) == 0.0) continue;
    const Vec3 x = points_.value(i, predicted);
    for (std::uint32_t j = 0; j < model_.colliders.size(); ++j)
      if (nearest_surface(model_.colliders[j].shape, x).distance < points_.point(i).radius + margin)
        near_.push_back({i, j});
  }
}

void ContactSolver::touch(const Pair& pair, const Vec3& normal) {
  if (std::any_of(touches_.begin(), touches_.end(), [&](const Touch& known) { return known.pair == pair; }))
    return;
  touches_.push_back({pair, normal, points_.value(pair.point, *start_velocity_).dot(normal)});
}

void ContactSolver::solve(Vectors& position) {
  for (const Pair& pair : near_) {
    const Collider& collider = model_.colliders[pair.collider];
    const Vec3 x = points_.value(pair.point, position);
    const Surface surface = nearest_surface(collider.shape, x);
    const double depth = points_.point(pair.point).radius - surface.distance;
    if (!(depth > 0.0)) continue;
    const Vec3 moved = x - points_.value(pair.point, *start_);
    const Vec3 slide = moved - surface.normal * moved.dot(surface.normal);
    const double way = slide.norm(), held = collider.friction * depth;
    const double stopped = way > held ? held / way : 1.0;
    points_.move(pair.point, surface.normal * depth - stopped * slide, position);
    if (collider.restitution > 0.0) touch(pair, surface.normal);
  }
}

void ContactSolver::rebound(double h, Vectors& velocity) const {
  const double resting = 2.0 * model_.gravity.norm() * h;
  for (const Touch& touch : touches_) {
    if (touch.approach > -resting) continue;
    const double wanted = -model_.colliders[touch.pair.collider].restitution * touch.approach;
    const double has = points_.value(touch.pair.point, velocity).dot(touch.normal);
    if (has < wanted) points_.move(touch.pair.point, (wanted - has) * touch.normal, velocity);
  }
}

}  // namespace taut
