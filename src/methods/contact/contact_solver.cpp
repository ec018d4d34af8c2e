#include "contact/contact_solver.h"

namespace taut {
namespace {

constexpr double reach_ahead = 0.02;  // m, that links may push something within a step

}  // namespace

ContactSolver::ContactSolver(const Model& model)
    : model_(model), points_(model), ground_(model), solids_(model.colliders) {
  if (touches_only_ground(model)) return;  // which is ground_'s
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (points_.weight(i) > 0.0) touching_.push_back(i);
}

// Whether it isn't ground_ that sees to a point on a solid.
bool ContactSolver::solves(const Pair& pair) const {
  return !is_plain(points_.point(pair.point)) || as_ground(model_.colliders[pair.collider]) == nullptr;
}

void ContactSolver::begin_step(const std::vector<ContactSlip>& slips, const Vectors& start,
                               const Vectors& velocity, const Vectors& predicted) {
  start_ = &start;
  touched_ = false;
  start_velocity_ = &velocity;
  near_.clear();
  touches_.clear();
  for (const std::uint32_t point : touching_) {
    const Vec3 x = points_.value(point, predicted);
    const double reach = points_.point(point).radius + reach_ahead;
    solids_.find(x, reach, around_);
    for (const std::uint32_t collider : around_)
      if (solves({point, collider}) && nearest_surface(model_.colliders[collider].shape, x).distance < reach)
        near_.push_back({point, collider});
  }
  has_touched_.assign(near_.size(), false);
  frictions_.clear();
  if (!points_.any_static_friction()) return;
  ContactSlipReader known(slips);
  for (const Pair& pair : near_) frictions_.emplace_back(known.slip(pair.point, pair.collider));
}

void ContactSolver::touch(std::size_t near, const Vec3& normal) {
  if (has_touched_[near]) return;
  has_touched_[near] = true;
  const Pair& pair = near_[near];
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
    if (collider.restitution > 0.0) touch(i, surface.normal);
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
