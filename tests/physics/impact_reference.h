#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut::test {

/// Motion of rigid links and plastic contacts without friction, integrated for itself with the moments of
/// impact and release located, and shared with no method:
///   M a = M g + Gᵀλ + Nᵀν,  G a + Ġ v = 0,  0 ≤ ν ⊥ N a + Ṅ v ≥ 0  between events,
///   M (v⁺ − v⁻) = GᵀΛ + NᵀΥ,  G v⁺ = 0,  0 ≤ Υ ⊥ N v⁺ ≥ 0  at an impact,
/// links and contacts all at once. Which contacts carry is found by trying every set of them. Contacts are
/// those of single masses with the ground and of balls of different bodies.
class ImpactReference {
 public:
  ImpactReference(const Model& model, const State& start, double step) : model_(model), step_(step) {
    const auto size = static_cast<Eigen::Index>(3 * model.masses.size());
    place_ = speed_ = weight_ = gravity_ = Vector::Zero(size);
    for (std::size_t i = 0; i < model.masses.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(3 * i);
      place_.segment<3>(at) = start.position.at(i);
      speed_.segment<3>(at) = start.velocity.at(i);
      weight_.segment<3>(at).setConstant(model.masses.inverse_mass[i]);
      if (!model.masses.pinned(i)) gravity_.segment<3>(at) = model.gravity;
    }
    for (std::size_t i = 0; i < model.contacts.size(); ++i) {
      for (const Collider& collider : model.colliders)
        if (as_ground(collider)) contacts_.push_back({i, i, as_ground(collider)});
      for (std::size_t j = i + 1; j < model.contacts.size(); ++j)
        if (model.contacts[i].body != model.contacts[j].body) contacts_.push_back({i, j, nullptr});
    }
  }

  /// The state after a time (s).
  State at(double time) {
    while (time_ < time) {
      const double h = std::min(step_, time - time_);
      const double until = first_event(h);
      advance(until);
      time_ += until;
      if (until < h) pass_event();
    }
    State state;
    for (Eigen::Index i = 0; i < place_.size(); i += 3) {
      state.position.push_back(place_.segment<3>(i));
      state.velocity.push_back(speed_.segment<3>(i));
    }
    return state;
  }
  /// Impacts and releases on the way.
  int events() const { return events_; }

 private:
  using Vector = Eigen::VectorXd;
  struct Contact {
    std::size_t a, b;  // of Model::contacts
    const HalfSpace* ground;
  };
  // Rows of links, then of contacts: their gradients, and what their rates of change hold beside G a.
  struct Rows {
    Eigen::MatrixXd gradient;
    Vector curvature;
  };

  Eigen::Index first_of(std::size_t contact) const {
    return static_cast<Eigen::Index>(3 * model_.contacts[contact].masses[0]);
  }
  double gap(const Contact& contact, const Vector& place) const {
    const Vec3 a = place.segment<3>(first_of(contact.a));
    const double radius = model_.contacts[contact.a].radius;
    if (contact.ground) return (a - contact.ground->point).dot(contact.ground->normal) - radius;
    return (a - place.segment<3>(first_of(contact.b))).norm() - radius - model_.contacts[contact.b].radius;
  }
  Rows rows(const Vector& place, const Vector& speed, const std::vector<std::size_t>& touching) const {
    const auto links = static_cast<Eigen::Index>(model_.links.size());
    const Eigen::Index count = links + static_cast<Eigen::Index>(touching.size());
    Rows rows{Eigen::MatrixXd::Zero(count, place.size()), Vector::Zero(count)};
    for (Eigen::Index row = 0; row < links; ++row) {
      const auto link = static_cast<std::size_t>(row);
      const Eigen::Index a = 3 * model_.links.a[link], b = 3 * model_.links.b[link];
      const Vec3 apart = place.segment<3>(a) - place.segment<3>(b);
      rows.gradient.block<1, 3>(row, a) = apart.transpose();
      rows.gradient.block<1, 3>(row, b) = -apart.transpose();
      rows.curvature[row] = (speed.segment<3>(a) - speed.segment<3>(b)).squaredNorm();
    }
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const Contact& contact = contacts_[touching[i]];
      const Eigen::Index row = links + static_cast<Eigen::Index>(i), a = first_of(contact.a);
      if (contact.ground) {
        rows.gradient.block<1, 3>(row, a) = contact.ground->normal.transpose();
        continue;
      }
      const Eigen::Index b = first_of(contact.b);
      const Vec3 apart = place.segment<3>(a) - place.segment<3>(b),
                 passing = speed.segment<3>(a) - speed.segment<3>(b);
      const Vec3 normal = apart.normalized();
      rows.gradient.block<1, 3>(row, a) = normal.transpose();
      rows.gradient.block<1, 3>(row, b) = -normal.transpose();
      rows.curvature[row] =
          (passing.squaredNorm() - normal.dot(passing) * normal.dot(passing)) / apart.norm();
    }
    return rows;
  }
  // Multipliers that bring G x + c to nothing, all rows alike.
  Vector answer(const Rows& rows, const Vector& x) const {
    const Eigen::MatrixXd matrix = rows.gradient * weight_.asDiagonal() * rows.gradient.transpose();
    return matrix.ldlt().solve(-(rows.gradient * x + rows.curvature));
  }
  Vector acceleration(const Vector& place, const Vector& speed) const {
    const Rows all = rows(place, speed, carrying_);
    return gravity_ + weight_.cwiseProduct(all.gradient.transpose() * answer(all, gravity_));
  }
  // The set of these contacts that carry, which push, while the others part: of x itself, or of its change.
  std::vector<std::size_t> complementary(const std::vector<std::size_t>& touching, const Vector& x,
                                         bool curved) const {
    constexpr double tolerance = 1e-9;
    Rows every = rows(place_, speed_, touching);
    if (!curved) every.curvature.setZero();
    const auto links = static_cast<Eigen::Index>(model_.links.size());
    for (std::uint32_t set = 0; set < 1U << touching.size(); ++set) {
      std::vector<std::size_t> some;
      for (std::size_t i = 0; i < touching.size(); ++i)
        if (set >> i & 1U) some.push_back(touching[i]);
      Rows few = rows(place_, speed_, some);
      if (!curved) few.curvature.setZero();
      const Vector multipliers = answer(few, x);
      if ((multipliers.tail(static_cast<Eigen::Index>(some.size())).array() < -tolerance).any()) continue;
      const Vector after = x + weight_.cwiseProduct(few.gradient.transpose() * multipliers);
      const Vector rates = every.gradient * after + every.curvature;
      if ((rates.tail(rates.size() - links).array() < -tolerance).any()) continue;
      return some;
    }
    ADD_FAILURE() << "no set of contacts carries at " << time_ << " s";
    return {};
  }

  // Runge and Kutta's classic step; then back onto what holds, which it leaves by its own error.
  void advance(double h) {
    const Vector place = place_, speed = speed_;
    const Vector a1 = acceleration(place, speed), v2 = speed + 0.5 * h * a1;
    const Vector a2 = acceleration(place + 0.5 * h * speed, v2), v3 = speed + 0.5 * h * a2;
    const Vector a3 = acceleration(place + 0.5 * h * v2, v3), v4 = speed + h * a3;
    const Vector a4 = acceleration(place + h * v3, v4);
    place_ = place + h / 6.0 * (speed + 2.0 * v2 + 2.0 * v3 + v4);
    speed_ = speed + h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    project();
  }
  void project() {
    const auto links = static_cast<Eigen::Index>(model_.links.size());
    for (int round = 0; round < 3; ++round) {
      Rows off = rows(place_, speed_, carrying_);
      for (Eigen::Index row = 0; row < off.curvature.size(); ++row) {
        const auto i = static_cast<std::size_t>(row);
        const double length = row < links ? model_.links.length[i] : 0.0;
        off.curvature[row] =
            row < links
                ? 0.5 * (off.gradient.block<1, 3>(row, 3 * model_.links.a[i]).squaredNorm() - length * length)
                : gap(contacts_[carrying_[static_cast<std::size_t>(row - links)]], place_);
      }
      place_ += weight_.cwiseProduct(off.gradient.transpose() * answer(off, Vector::Zero(place_.size())));
    }
    Rows now = rows(place_, speed_, carrying_);
    now.curvature.setZero();
    speed_ += weight_.cwiseProduct(now.gradient.transpose() * answer(now, speed_));
  }

  bool carries(std::size_t contact) const { return std::ranges::find(carrying_, contact) != carrying_.end(); }
  // Whether something has met, or a contact that carries would have to pull.
  bool is_past() const {
    for (std::size_t i = 0; i < contacts_.size(); ++i)
      if (!carries(i) && gap(contacts_[i], place_) < -met) return true;
    const Vector multipliers = answer(rows(place_, speed_, carrying_), gravity_);
    return (multipliers.tail(static_cast<Eigen::Index>(carrying_.size())).array() < 0.0).any();
  }
  double first_event(double h) {
    const Vector place = place_, speed = speed_;
    const auto past_after = [&](double part) {
      advance(part);
      const bool past = is_past();
      place_ = place;
      speed_ = speed;
      return past;
    };
    if (!past_after(h)) return h;
    double low = 0.0, high = h;
    for (int i = 0; i < 45; ++i) (past_after(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return high;
  }
  void pass_event() {
    ++events_;
    std::vector<std::size_t> touching;
    for (std::size_t i = 0; i < contacts_.size(); ++i)
      if (gap(contacts_[i], place_) < near) touching.push_back(i);
    const std::vector<std::size_t> stopped = complementary(touching, speed_, false);
    Rows hit = rows(place_, speed_, stopped);
    hit.curvature.setZero();
    speed_ += weight_.cwiseProduct(hit.gradient.transpose() * answer(hit, speed_));
    // Those that the impact leaves at rest may carry; the others part.
    std::vector<std::size_t> resting;
    const Rows all = rows(place_, speed_, touching);
    const auto links = static_cast<Eigen::Index>(model_.links.size());
    for (std::size_t i = 0; i < touching.size(); ++i)
      if (std::abs(all.gradient.row(links + static_cast<Eigen::Index>(i)).dot(speed_)) < 1e-7)
        resting.push_back(touching[i]);
    carrying_ = complementary(resting, gravity_, true);
  }

  static constexpr double met = 1e-12, near = 1e-9;  // m
  const Model& model_;
  double step_, time_ = 0.0;
  Vector place_, speed_, weight_, gravity_;
  std::vector<Contact> contacts_;
  std::vector<std::size_t> carrying_;
  int events_ = 0;
};

}  // namespace taut::test
