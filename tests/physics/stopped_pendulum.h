#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/description.h"

namespace taut::test {

/// Two masses of 1 kg on links of 1 m, released level and straight; the elbow bends by 30 degrees at most.
inline Description stopped_pendulum() {
  Description description;
  MassSpec shoulder, elbow, hand;
  shoulder.name = "shoulder";
  shoulder.pinned = true;
  elbow.name = "elbow";
  elbow.position = {1.0, 0.0, 0.0};
  hand.name = "hand";
  hand.position = {2.0, 0.0, 0.0};
  description.masses = {shoulder, elbow, hand};
  description.links = {LinkSpec{"shoulder", "elbow", 1.0, {}}, LinkSpec{"elbow", "hand", 1.0, {}}};
  AngleSpec angle;
  angle.masses = {"shoulder", "elbow", "hand"};
  angle.min = 150.0;
  description.angles = {angle};
  return description;
}

/// The same in its two angles from hanging down, integrated for itself with the moments of impact and release
/// located:
///   M q̈ = f + Gᵀλ,  G = (−1, 1),  λ ≤ 0 while q₂ − q₁ is at the stop,
/// and an impact's impulse along Gᵀ such that Gq̇ = 0 behind it: both links take their part at once.
class StoppedPendulum {
 public:
  explicit StoppedPendulum(double step) : step_(step) {}

  // Where the hand is at a time; the number of impacts and releases on the way is in events().
  Vec3 hand_at(double time) {
    while (time_ < time) {
      const double h = std::min(step_, time - time_);
      const double until = first_event(h);
      const State next = advanced(state_, until);
      state_ = next;
      time_ += until;
      if (until < h) pass_event();
    }
    return {std::sin(state_[0]) + std::sin(state_[1]), -std::cos(state_[0]) - std::cos(state_[1]), 0.0};
  }
  int events() const { return events_; }

 private:
  using State = Eigen::Vector4d;  // q₁, q₂ and their rates
  static constexpr double stop = 30.0 * std::numbers::pi / 180.0;

  static Eigen::Matrix2d inertia(const State& s) {
    const double c = std::cos(s[0] - s[1]);
    return Eigen::Matrix2d{{2.0, c}, {c, 1.0}};
  }
  static double multiplier(const State& s) {
    const Eigen::Vector2d g(-1.0, 1.0);
    const Eigen::Matrix2d inverse = inertia(s).inverse();
    return -g.dot(inverse * force(s)) / g.dot(inverse * g);
  }
  static Eigen::Vector2d force(const State& s) {
    const double sine = std::sin(s[0] - s[1]);
    return {-sine * s[3] * s[3] - 2.0 * 9.81 * std::sin(s[0]), sine * s[2] * s[2] - 9.81 * std::sin(s[1])};
  }
  State rate(const State& s) const {
    Eigen::Vector2d f = force(s);
    if (stopped_) f += multiplier(s) * Eigen::Vector2d(-1.0, 1.0);
    const Eigen::Vector2d acceleration = inertia(s).inverse() * f;
    return {s[2], s[3], acceleration[0], acceleration[1]};
  }
  State advanced(const State& s, double h) const {  // Runge and Kutta's classic
    const State a = rate(s), b = rate(s + 0.5 * h * a), c = rate(s + 0.5 * h * b), d = rate(s + h * c);
    return s + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  bool is_past(const State& s) const { return stopped_ ? multiplier(s) > 0.0 : s[1] - s[0] > stop; }
  double first_event(double h) const {
    if (!is_past(advanced(state_, h))) return h;
    double low = 0.0, high = h;
    for (int i = 0; i < 60; ++i)
      (is_past(advanced(state_, 0.5 * (low + high))) ? high : low) = 0.5 * (low + high);
    return high;
  }
  void pass_event() {
    ++events_;
    stopped_ = !stopped_;
    if (!stopped_) return;
    const Eigen::Vector2d g(-1.0, 1.0);
    const Eigen::Vector2d answer = inertia(state_).inverse() * g;
    state_.tail<2>() -= answer * (g.dot(state_.tail<2>()) / g.dot(answer));
  }

  double step_, time_ = 0.0;
  State state_{0.5 * std::numbers::pi, 0.5 * std::numbers::pi, 0.0, 0.0};
  bool stopped_ = false;
  int events_ = 0;
};

}  // namespace taut::test
