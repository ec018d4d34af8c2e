#include "contact/body_contacts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace taut {
namespace {

constexpr double friction = 0.8;  // Coulomb's coefficient between bodies
constexpr double margin = 0.02;   // m, that a listed pair may be apart
constexpr double stay = 0.005;    // m, that a ball may move before the list is made anew

}  // namespace

BodyContacts::BodyContacts(const Model& model) : points_(model) {
  double largest = 0.0;
  for (std::uint32_t i = 0; i < model.contacts.size(); ++i) {
    if (model.contacts[i].body == no_body) continue;
    balls_.push_back(i);
    largest = std::max(largest, model.contacts[i].radius);
  }
  cell_size_ = 2.0 * largest + margin;
  grid_.begins.resize(2 * std::bit_ceil(balls_.size() + 1) + 1);
}

std::size_t BodyContacts::bucket_of(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t at : cell) hash = (hash ^ static_cast<std::uint64_t>(at)) * 0x9e3779b97f4a7c15U;
  return (hash >> 32U) & (grid_.begins.size() - 2);
}

// Counting sort of the balls by bucket.
void BodyContacts::fill_grid(const std::vector<Vec3>& centres) {
  grid_.cells.resize(balls_.size());
  grid_.balls.resize(balls_.size());
  std::fill(grid_.begins.begin(), grid_.begins.end(), 0U);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      grid_.cells[i][static_cast<std::size_t>(axis)] =
          static_cast<std::int64_t>(std::floor(std::clamp(centres[i][axis] / cell_size_, -1e15, 1e15)));
    ++grid_.begins[bucket_of(grid_.cells[i]) + 1];
  }
  for (std::size_t bucket = 1; bucket < grid_.begins.size(); ++bucket)
    grid_.begins[bucket] += grid_.begins[bucket - 1];
  std::vector<std::uint32_t> next(grid_.begins.begin(), grid_.begins.end() - 1);
  for (std::uint32_t i = 0; i < balls_.size(); ++i) grid_.balls[next[bucket_of(grid_.cells[i])]++] = i;
}

// Pairs of this ball and later ones in the cells around it.
void BodyContacts::find_pairs(std::uint32_t ball, const std::vector<Vec3>& centres) {
  const ContactPoint& point = points_.point(balls_[ball]);
  const Cell& home = grid_.cells[ball];
  for (int around = 0; around < 27; ++around) {
    const Cell cell{home[0] + around % 3 - 1, home[1] + around / 3 % 3 - 1, home[2] + around / 9 - 1};
    const std::size_t bucket = bucket_of(cell);
    for (std::uint32_t k = grid_.begins[bucket]; k < grid_.begins[bucket + 1]; ++k) {
      const std::uint32_t other = grid_.balls[k];
      if (other <= ball || grid_.cells[other] != cell) continue;
      const ContactPoint& met = points_.point(balls_[other]);
      const double reach = point.radius + met.radius + margin;
      if (met.body == point.body || (centres[ball] - centres[other]).squaredNorm() > reach * reach) continue;
      pairs_.emplace_back(balls_[ball], balls_[other]);
    }
  }
}

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
  if (balls_.empty()) return;
  if (moved_since_search(predicted)) {
    pairs_.clear();
    centres_.clear();
    for (const std::uint32_t point : balls_) centres_.push_back(points_.value(point, predicted));
    fill_grid(centres_);
    for (std::uint32_t ball = 0; ball < balls_.size(); ++ball) find_pairs(ball, centres_);
    std::sort(pairs_.begin(), pairs_.end());
  }
  frictions_.clear();
  if (!points_.any_static_friction()) return;
  ContactSlipReader known(slips);
  for (const auto& [a, b] : pairs_) frictions_.emplace_back(known.slip(a, b));
}

// How far a has moved since the start of the step, as seen from b.
Vec3 BodyContacts::moved(std::uint32_t a, std::uint32_t b, const Vectors& position) const {
  return (points_.value(a, position) - points_.value(a, *start_)) -
         (points_.value(b, position) - points_.value(b, *start_));
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
    const Vec3 held = remembers ? frictions_[i].hold(friction, overlap, normal, way)
                                : coulomb_friction(friction, overlap, normal, way);
    const Vec3 change = overlap * normal + held;
    points_.move(a, weight_a / (weight_a + weight_b) * change, position);
    points_.move(b, -weight_b / (weight_a + weight_b) * change, position);
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
