#include "contact/body_contacts.h"

#include <algorithm>

namespace taut {
namespace {

constexpr double stay = 0.005;  // m, that a ball may move before the list is made anew

}  // namespace

std::vector<BodyBall> BodyContacts::touching_balls(const Model& model, std::vector<std::uint32_t>& points) {
  std::vector<BodyBall> balls;
  for (std::uint32_t i = 0; i < model.contacts.size(); ++i) {
    if (model.contacts[i].body == no_body) continue;
    points.push_back(i);
    balls.push_back({model.contacts[i].radius, model.contacts[i].body});
  }
  return balls;
}

BodyContacts::BodyContacts(const Model& model)
    : points_(model),
      near_(touching_balls(model, balls_), contact_margin),
      any_faces_(!model.faces.empty()) {}

bool BodyContacts::moved_since_search(const Vectors& position) const {
  if (centres_.size() != balls_.size()) return true;
  for (std::size_t ball = 0; ball < balls_.size(); ++ball)
    if (!((points_.value(balls_[ball], position) - centres_[ball]).squaredNorm() < stay * stay)) return true;
  return false;
}

void BodyContacts::begin_step(const std::vector<ContactSlip>& slips, const Vectors& start,
                              const Vectors& predicted) {
  start_ = &start;
  touched_ = false;
  impulse_way_ = 0.0;
  if (balls_.empty()) return;
  if (moved_since_search(predicted)) {
    centres_.clear();
    for (const std::uint32_t point : balls_) centres_.push_back(points_.value(point, predicted));
    near_.find(centres_, most_near_pairs, pairs_);
    crowded_ = pairs_.size() > most_near_pairs;
    if (crowded_) {
      pairs_ = {};
      centres_.clear();  // to be looked for again
    }
    for (auto& [a, b] : pairs_) {
      a = balls_[a];
      b = balls_[b];
    }
    if (any_faces_)
      std::erase_if(pairs_, [this](const auto& pair) {
        const ContactPoint &a = points_.point(pair.first), &b = points_.point(pair.second);
        return (a.of_faces && (b.of_faces || is_ball(b))) || (b.of_faces && is_ball(a));
      });
  }
  frictions_.clear();
  if (!points_.any_static_friction()) return;
  ContactSlipReader known(slips);
  for (const auto& [a, b] : pairs_) frictions_.emplace_back(known.slip(a, b));
}

// How far a point has moved since the start of the step.
Vec3 BodyContacts::way_of(std::uint32_t point, const Vectors& position) const {
  return points_.value(point, position) - points_.value(point, *start_);
}

// The same of a, as seen from b.
Vec3 BodyContacts::moved(std::uint32_t a, std::uint32_t b, const Vectors& position) const {
  return way_of(a, position) - way_of(b, position);
}

void BodyContacts::solve(Vectors& position) {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const auto [a, b] = pairs_[i];
    const double weight_a = points_.weight(a), weight_b = points_.weight(b);
    const Vec3 apart = points_.value(a, position) - points_.value(b, position);
    const double distance = apart.norm(),
                 overlap = points_.point(a).radius + points_.point(b).radius - distance;
    if (!(overlap > 0.0) || distance == 0.0 || weight_a + weight_b == 0.0) continue;
    touched_ = true;
    const Vec3 normal = apart / distance, way = moved(a, b, position);
    const bool remembers = points_.point(a).static_friction && points_.point(b).static_friction;
    const Vec3 held = remembers ? frictions_[i].hold(body_friction, overlap, normal, way)
                                : coulomb_friction(body_friction, overlap, normal, way);
    const Vec3 change = overlap * normal + held;
    points_.move(a, weight_a / (weight_a + weight_b) * change, position);
    points_.move(b, -weight_b / (weight_a + weight_b) * change, position);
    if (weight_a == 0.0) impulse_way_ -= change.dot(way_of(a, position)) / weight_b;
    if (weight_b == 0.0) impulse_way_ += change.dot(way_of(b, position)) / weight_a;
  }
}

void BodyContacts::keep(const Vectors& position, std::vector<ContactSlip>& slips) const {
  slips.clear();
  for (std::size_t i = 0; i < frictions_.size(); ++i) {
    const auto [a, b] = pairs_[i];
    if (frictions_[i].touched()) slips.push_back({a, b, frictions_[i].slip(moved(a, b, position))});
  }
}

}  // namespace taut
