#include "contact/contact_solver.h"

#include <algorithm>

namespace taut {
namespace {

constexpr double margin = 0.02;  // m, that links may push something within a step

}  // namespace

ContactSolver::ContactSolver(const Model& model) : model_(model), points_(model) {}

void ContactSolver::begin_step(const std::vector<Grip>& grips, const Vectors& start, const Vectors& velocity,
                               const Vectors& predicted) {
  start_ = &start;
  touched_ = false;
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
  frictions_.clear();
  if (!points_.any_holds()) return;
  GripReader known(grips);
  for (const Pair& pair : near_) frictions_.emplace_back(known.slip(pair.point, pair.collider));
}

void ContactSolver::touch(const Pair& pair, const Vec3& normal) {
  if (std::any_of(touches_.begin(), touches_.end(), [&](const Touch& known) { return known.pair == pair; }))
    return;
  touches_.push_back({pair, normal, points_.value(pair.point, *start_velocity_).dot(normal)});
}

void ContactSolver::solve(Vectors& position) {
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const Pair& pair = near_[i];
    const Collider& collider = model_.colliders[pair.collider];
    const Vec3 x = points_.value(pair.point, position);
    const Surface surface = nearest_surface(collider.shape, x);
    const double depth = points_.point(pair.point).radius - surface.distance;
    if (!(depth > 0.0)) continue;
    touched_ = true;
    const Vec3 moved = x - points_.value(pair.point, *start_);
    const Vec3 held = points_.point(pair.point).holds
                          ? frictions_[i].hold(collider.friction, depth, surface.normal, moved)
                          : held_back(collider.friction, depth, surface.normal, moved);
    points_.move(pair.point, surface.normal * depth + held, position);
    if (collider.restitution > 0.0) touch(pair, surface.normal);
  }
}

void ContactSolver::keep(const Vectors& position, std::vector<Grip>& grips) const {
  grips.clear();
  for (std::size_t i = 0; i < frictions_.size(); ++i) {
    const auto [point, collider] = near_[i];
    if (!frictions_[i].touched()) continue;
    const Vec3 moved = points_.value(point, position) - points_.value(point, *start_);
    grips.push_back({point, collider, frictions_[i].slip(moved)});
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
