#include "contact/contact_solver.h"

#include <algorithm>

namespace taut {
namespace {

constexpr double reach_ahead = 0.02;  // m, that links may push something within a step

}  // namespace

ContactSolver::ContactSolver(const Model& model) : model_(model), points_(model), ground_(model) {
  if (touches_only_ground(model)) return;  // which is ground_'s
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    if (points_.weight(i) == 0.0) continue;
    for (std::uint32_t j = 0; j < model.colliders.size(); ++j)
      if (!is_plain(points_.point(i)) || as_ground(model.colliders[j]) == nullptr) pairs_.push_back({i, j});
  }
}

void ContactSolver::begin_step(const std::vector<ContactSlip>& slips, const Vectors& start,
                               const Vectors& velocity, const Vectors& predicted) {
  start_ = &start;
  touched_ = false;
  start_velocity_ = &velocity;
  near_.clear();
  touches_.clear();
  for (std::size_t k = 0; k < pairs_.size();) {
    const std::uint32_t point = pairs_[k].point;
    const Vec3 x = points_.value(point, predicted);
    for (; k < pairs_.size() && pairs_[k].point == point; ++k)
      if (nearest_surface(model_.colliders[pairs_[k].collider].shape, x).distance <
          points_.point(point).radius + reach_ahead)
        near_.push_back(pairs_[k]);
  }
  frictions_.clear();
  if (!points_.any_static_friction()) return;
  ContactSlipReader known(slips);
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
    const Vec3 held = points_.point(pair.point).static_friction
                          ? frictions_[i].hold(collider.friction, depth, surface.normal, moved)
                          : coulomb_friction(collider.friction, depth, surface.normal, moved);
    points_.move(pair.point, surface.normal * depth + held, position);
    if (collider.restitution > 0.0) touch(pair, surface.normal);
  }
  touched_ = ground_.solve(*start_, position) || touched_;
}

void ContactSolver::keep(const Vectors& position, std::vector<ContactSlip>& slips) const {
  slips.clear();
  for (std::size_t i = 0; i < frictions_.size(); ++i) {
    const auto [point, collider] = near_[i];
    if (!frictions_[i].touched()) continue;
    const Vec3 moved = points_.value(point, position) - points_.value(point, *start_);
    slips.push_back({point, collider, frictions_[i].slip(moved)});
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
