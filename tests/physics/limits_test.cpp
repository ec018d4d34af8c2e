// Limits on angles in motion.

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<std::string> limit_methods() {
  return methods_that([](const Capabilities& can) { return can.limits; });
}

class LimitMethods : public ::testing::TestWithParam<std::string> {};

// Two masses of 1 kg on links of 1 m, released level and straight; the elbow bends by 30 degrees at most.
Description stopped_pendulum() {
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

// The same in its two angles from hanging down, with the moments of impact and release located.
//   M q̈ = f + Gᵀλ,  G = (−1, 1),  λ ≤ 0 while q₂ − q₁ is at the stop.
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
  static constexpr double stop = 30.0 * pi / 180.0;

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
  State state_{0.5 * pi, 0.5 * pi, 0.0, 0.0};
  bool stopped_ = false;
  int events_ = 0;
};

constexpr double duration = 0.75;  // s

TEST(StoppedPendulumReference, IsCertified) {
  StoppedPendulum coarse(1e-3), fine(5e-4);
  const Vec3 place = fine.hand_at(duration);
  EXPECT_GE(fine.events(), 1);
  EXPECT_LT((coarse.hand_at(duration) - place).norm(), 1e-9);
}

// An impact falls anywhere within a step, so no method is of more than first order across it.
TEST_P(LimitMethods, DoublePendulumWithAStopConvergesToTheReferenceWithFirstOrder) {
  const Vec3 exact = StoppedPendulum(5e-4).hand_at(duration);
  const Built built = build_valid(stopped_pendulum());
  std::vector<double> steps, errors;
  // The mean over neighbouring step sizes: where in the step the impact falls is as good as random.
  for (const double rate : {400.0, 1600.0, 6400.0}) {
    double sum = 0.0;
    constexpr int neighbours = 8;
    for (int i = 0; i < neighbours; ++i) {
      const double near = rate + 4.0 * i;
      sum += (run(built, settings(GetParam(), near, 60.0), duration).position.at(2) - exact).norm();
    }
    steps.push_back(1.0 / rate);
    errors.push_back(sum / neighbours);
  }
  EXPECT_GT(observed_order(steps, errors), 0.8);
  EXPECT_LT(observed_order(steps, errors), 1.4);
  EXPECT_LT(errors.back(), 5e-3);
}

TEST_P(LimitMethods, NoStopIsPassedByMoreThanADegree) {
  const Built built = build_valid(stopped_pendulum());
  State state = built.start;
  for (int frame = 0; frame < 100; ++frame) {
    Built next{built.model, state, {}};
    state = run(next, settings(GetParam(), 1000.0, 20.0), 0.02);
    EXPECT_LT(largest_limit_excess(built.model, state), pi / 180.0) << "at " << state.time << " s";
  }
}

// A body with a stop at its elbow, tumbling freely.
TEST_P(LimitMethods, AStopLeavesMomentumAlone) {
  Description description = stopped_pendulum();
  description.gravity = Vec3::Zero();
  description.masses[0].pinned = false;
  description.masses[0].velocity = {0.3, 1.0, 0.2};
  description.masses[2].velocity = {0.0, 2.0, 0.5};
  const Built built = build_valid(description);
  const Vec3 before = linear_momentum(built.model, built.start);
  // Every correction rounds positions at 4e-16 m, and so velocities at that over h; there are ten thousand,
  // at random.
  const State rough = run(built, settings(GetParam(), 1000.0, 3.0), 1.0);
  EXPECT_LT((linear_momentum(built.model, rough) - before).norm(), 1e-10 * before.norm());
  const State fine = run(built, settings(GetParam(), 8000.0, 20.0), 1.0);
  const Vec3 spin = angular_momentum(built.model, built.start);
  EXPECT_LT((angular_momentum(built.model, fine) - spin).norm(), 0.01 * spin.norm());
}

TEST_P(LimitMethods, AStopThatIsReachedAtRestInjectsNothing) {
  Description description = stopped_pendulum();
  description.gravity = Vec3::Zero();
  description.angles[0].min = 180.0;
  const Built built = build_valid(description);
  const State end = run(built, settings(GetParam(), 600.0, 5.0), 1.0);
  EXPECT_LT(position_error(end, built.start), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Registry, LimitMethods, ::testing::ValuesIn(limit_methods()), case_name);

// A soft stop gives way to a torque by compliance × torque: 1 kg at 1 m to the side of a pinned hinge.
TEST(SoftLimits, GiveWayByComplianceTimesTorque) {
  Description description;
  description.drag = 20.0;
  MassSpec far, hinge, bob;
  far.name = "far";
  far.position = {-1.0, 0.0, 0.0};
  far.pinned = true;
  hinge.name = "hinge";
  hinge.pinned = true;
  bob.name = "bob";
  bob.position = {1.0, 0.0, 0.0};
  description.masses = {far, hinge, bob};
  description.links = {LinkSpec{"hinge", "bob", 1.0, {}}};
  AngleSpec angle;
  angle.masses = {"far", "hinge", "bob"};
  angle.min = 180.0;
  angle.compliance = 0.01;
  description.angles = {angle};
  const Built built = build_valid(description);
  const State end = run(built, settings("xpbd", 1000.0, 20.0), 5.0);
  const double sunk = std::atan2(-end.position.y[2], end.position.x[2]);
  EXPECT_NEAR(sunk, 0.01 * 9.81 * std::cos(sunk), 1e-4);
}

}  // namespace
}  // namespace taut::test
