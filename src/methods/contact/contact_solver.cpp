#include "contact/contact_solver.h"

#include <algorithm>

#include "model/solid_mesh.h"

namespace taut {
namespace {

constexpr double reach_ahead = 0.02;  // m, that links may push something within a step
// Of a solid with hollows: pushes in a pass beyond the first, and of the depth of that what is worth one.
constexpr int most_sides = 4;
constexpr double noticeable_depth = 1e-3;

std::vector<Shape> shapes_of(const Model& model) {
  std::vector<Shape> shapes;
  for (const Collider& collider : model.colliders) shapes.push_back(collider.shape);
  return shapes;
}

bool is_thin(const Collider& collider) {
  return std::holds_alternative<MeshSolid>(collider.shape);
}

// How far (m) any place of a solid goes from one placement to another: no place farther than a corner of the
// box around it.
double farthest_way(const MeshSolid& solid, const Placement& start, const Placement& end) {
  const Bounds& own = solid.mesh->bounds();
  double farthest = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 at = solid.place({(corner & 1U) != 0 ? own.low.x() : own.high.x(),
                                 (corner & 2U) != 0 ? own.low.y() : own.high.y(),
                                 (corner & 4U) != 0 ? own.low.z() : own.high.z()});
    farthest = std::max(farthest, (end.place(at) - start.place(at)).norm());
  }
  return farthest;
}

template <class Wanted>
std::vector<std::uint32_t> solids_that(const Model& model, const Wanted& wanted) {
  std::vector<std::uint32_t> solids;
  for (std::uint32_t i = 0; i < model.colliders.size(); ++i)
    if (wanted(model.colliders[i])) solids.push_back(i);
  return solids;
}

std::vector<std::uint32_t> moving_solids(const Model& model) {
  return solids_that(model, [](const Collider& collider) { return collider.motion.has_value(); });
}

// But for those that GroundContacts sees to for all points that there are.
std::vector<std::uint32_t> still_solids(const Model& model) {
  const bool all_plain = std::ranges::all_of(model.contacts, is_plain);
  return solids_that(model, [&](const Collider& collider) {
    return !collider.motion && !(all_plain && as_ground(collider) != nullptr);
  });
}

}  // namespace

ContactSolver::ContactSolver(const Model& model)
    : model_(model),
      points_(model),
      ground_(model),
      shapes_(shapes_of(model)),
      moving_(moving_solids(model)),
      still_solids_(shapes_, still_solids(model)),
      any_thin_(std::ranges::any_of(model.colliders, is_thin)) {
  if (touches_only_ground(model)) return;  // which is ground_'s
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (points_.weight(i) > 0.0) touching_.push_back(i);
}

// Whether it isn't ground_ that sees to a point on a solid.
bool ContactSolver::solves(const Pair& pair) const {
  return !is_plain(points_.point(pair.point)) || as_ground(model_.colliders[pair.collider]) == nullptr;
}

void ContactSolver::move_solids(double start_time, double end_time) {
  if (moving_.empty()) return;
  rides_.clear();
  thin_way_ = 0.0;
  for (const std::uint32_t i : moving_) {
    const SolidMotion& motion = *model_.colliders[i].motion;
    rides_.push_back({i, placement_at(motion, start_time), placement_at(motion, end_time),
                      twist_at(motion, start_time), twist_at(motion, end_time)});
    shapes_[i] = moved(model_.colliders[i].shape, rides_.back().end);
    if (const auto* solid = std::get_if<MeshSolid>(&model_.colliders[i].shape))
      thin_way_ = std::max(thin_way_, farthest_way(*solid, rides_.back().start, rides_.back().end));
  }
  moving_solids_.emplace(shapes_, moving_);
}

const ContactSolver::Ride* ContactSolver::ride_of(std::uint32_t collider) const {
  if (rides_.empty() || !model_.colliders[collider].motion) return nullptr;
  return &*std::ranges::lower_bound(rides_, collider, {}, &Ride::collider);
}

// How far a solid has gone in this step, at a place that it has at its end.
Vec3 ContactSolver::way_of(const Ride& ride, const Vec3& place) {
  return place - ride.start.place(ride.end.back(place));
}

// How far a point has moved since the start of the step, as seen from the solid: beyond what has moved there
// with it.
Vec3 ContactSolver::moved_since_start(const Pair& pair, const Vectors& position) const {
  const Vec3 x = points_.value(pair.point, position), moved = x - points_.value(pair.point, *start_);
  const Ride* ride = ride_of(pair.collider);
  return ride == nullptr ? moved : Vec3(moved - way_of(*ride, x));
}

// The surface of a solid as a point meets it that was somewhere, as seen from the solid, when the step began.
std::optional<Surface> ContactSolver::surface_at(const Pair& pair, const Vec3& x, double reach) const {
  const Shape& shape = shapes_[pair.collider];
  if (!std::holds_alternative<MeshSolid>(shape)) return surface_within(shape, x, reach);
  const Vec3 from = points_.value(pair.point, *start_);
  const Ride* ride = ride_of(pair.collider);
  return surface_on_way(shape, ride == nullptr ? from : ride->end.place(ride->start.back(from)), x, reach);
}

void ContactSolver::begin_step(const std::vector<ContactSlip>& slips, const Vectors& start,
                               const Vectors& velocity, const Vectors& predicted, double start_time,
                               double end_time) {
  start_ = &start;
  touched_ = false;
  impulse_way_ = rebound_work_ = 0.0;
  start_velocity_ = &velocity;
  near_.clear();
  touches_.clear();
  move_solids(start_time, end_time);
  for (const std::uint32_t point : touching_) {
    const Vec3 x = points_.value(point, predicted);
    const double reach = points_.point(point).radius + reach_ahead;
    // What has no thickness to speak of may be behind what came from before it.
    const double way = any_thin_ ? (x - points_.value(point, start)).norm() : 0.0;
    around_.clear();
    still_solids_.find(x, reach + way, around_);
    if (moving_solids_) moving_solids_->find(x, reach + way + thin_way_, around_);
    std::sort(around_.begin(), around_.end());
    for (const std::uint32_t collider : around_)
      if (solves({point, collider}) && surface_at({point, collider}, x, reach))
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
  Vec3 velocity = points_.value(pair.point, *start_velocity_);
  if (const Ride* ride = ride_of(pair.collider))
    velocity -= ride->start_twist.velocity(points_.value(pair.point, *start_));
  touches_.push_back({pair, normal, velocity.dot(normal)});
}

void ContactSolver::solve(Vectors& position) {
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const double first = push_out(i, position);
    if (!(first > 0.0)) continue;
    touched_ = true;
    if (!is_thin(model_.colliders[near_[i].collider])) continue;
    // In a hollow what is pushed away from one side of it may be pushed into another.
    for (int more = 0; more < most_sides && push_out(i, position) > noticeable_depth * first; ++more) {
    }
  }
  touched_ = ground_.solve(*start_, position) || touched_;
}

// Gives the depth (m) that it had; 0 where it did not touch.
double ContactSolver::push_out(std::size_t near, Vectors& position) {
  const Pair& pair = near_[near];
  const Collider& collider = model_.colliders[pair.collider];
  const Vec3 x = points_.value(pair.point, position);
  const double radius = points_.point(pair.point).radius;
  const std::optional<Surface> surface = surface_at(pair, x, radius);
  const double depth = surface ? radius - surface->distance : 0.0;
  if (!(depth > 0.0)) return 0.0;
  const Vec3 moved = moved_since_start(pair, position);
  const Vec3 held = points_.point(pair.point).static_friction
                        ? frictions_[near].hold(collider.friction, depth, surface->normal, moved)
                        : coulomb_friction(collider.friction, depth, surface->normal, moved);
  const Vec3 change = surface->normal * depth + held;
  points_.move(pair.point, change, position);
  if (const Ride* ride = ride_of(pair.collider))
    impulse_way_ += change.dot(way_of(*ride, x)) / points_.weight(pair.point);
  if (collider.restitution > 0.0) touch(near, surface->normal);
  return depth;
}

void ContactSolver::keep(const Vectors& position, std::vector<ContactSlip>& slips) const {
  slips.clear();
  for (std::size_t i = 0; i < frictions_.size(); ++i) {
    const auto [point, collider] = near_[i];
    if (!frictions_[i].touched()) continue;
    slips.push_back({point, collider, frictions_[i].slip(moved_since_start(near_[i], position))});
  }
}

void ContactSolver::rebound(double h, const Vectors& position, Vectors& velocity) {
  const double resting = 2.0 * model_.gravity.norm() * h;
  for (const Touch& touch : touches_) {
    if (touch.approach > -resting) continue;
    double of_solid = 0.0;  // m/s
    if (const Ride* ride = ride_of(touch.pair.collider))
      of_solid = ride->end_twist.velocity(points_.value(touch.pair.point, position)).dot(touch.normal);
    const double wanted = of_solid - model_.colliders[touch.pair.collider].restitution * touch.approach;
    const double has = points_.value(touch.pair.point, velocity).dot(touch.normal);
    if (!(has < wanted)) continue;
    points_.move(touch.pair.point, (wanted - has) * touch.normal, velocity);
    rebound_work_ += (wanted - has) * of_solid / points_.weight(touch.pair.point);
  }
}

}  // namespace taut
