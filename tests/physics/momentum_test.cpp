// Momentum of free bodies, energy over many periods, and velocities at driven pins.

#include <numbers>

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

Built free_body(const std::string& method) {
  Description description = spinning_dumbbell();
  if (!find_method(method)->can.rigid) description.links[0].properties.stiffness = 1e4;
  return build_valid(description);
}

// Share of angular momentum (about the moving centre's start) lost in one turn at 6 rad/s.
double angular_loss(const std::string& method, double rate) {
  const Built built = free_body(method);
  const Vec3 before = angular_momentum(built.model, built.start);
  const double turn = 2.0 * std::numbers::pi / 6.0;
  const State end = run(built, settings(method, rate, 20.0), std::round(turn * rate) / rate);
  return (angular_momentum(built.model, end) - before).norm() / before.norm();
}

class KeepsAngularMomentum : public ::testing::TestWithParam<std::string> {};

TEST_P(KeepsAngularMomentum, ToRounding) {
  EXPECT_LT(angular_loss(GetParam(), 600.0), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Methods, KeepsAngularMomentum,
                         ::testing::Values("shake", "rattle", "spring-explicit"), case_name);

class LosesAngularMomentum : public ::testing::TestWithParam<std::string> {};

TEST_P(LosesAngularMomentum, AsTheStepShrinks) {
  const double coarse = angular_loss(GetParam(), 600.0), fine = angular_loss(GetParam(), 6000.0);
  EXPECT_GT(coarse, 1e-3);
  EXPECT_NEAR(fine, coarse / 10.0, 0.15 * coarse / 10.0);
}

INSTANTIATE_TEST_SUITE_P(Methods, LosesAngularMomentum,
                         ::testing::Values("verlet", "xpbd", "newton", "spring-implicit"), case_name);

// The largest energy error over the last 10 of 1000 periods is no larger than over the first 10, but for
// rounding.
TEST(Rattle, EnergyDoesNotDriftOverAThousandPeriods) {
  const Built built = build_valid(pendulum());
  const double at_start = energy(built.model, built.start).total();
  State state = built.start;
  const auto worst_of_ten_periods = [&] {
    double worst = 0.0;
    for (int step = 0; step < 2368; ++step) {
      EXPECT_EQ(simulate(built.model, state, settings("rattle", 100.0), 1).end, RunEnd::none);
      worst = std::max(worst, std::abs(energy(built.model, state).total() - at_start));
    }
    return worst;
  };
  const double first = worst_of_ten_periods();
  EXPECT_EQ(simulate(built.model, state, settings("rattle", 100.0), 236800 - 2 * 2368).end,
            RunEnd::none);
  EXPECT_LT(worst_of_ten_periods(), 1.05 * first);
}

// A link's end must move along with a pin that is driven fast: d·(v_bob − v_pin) = 0 with the pin's exact
// velocity.
TEST(Rattle, VelocitiesMeetAFastPin) {
  Description description = pendulum();
  description.masses[0].motion.sinusoid =
      SinusoidSpec{{0.05, 0.1, 0.0}, 60.0, 0.5 * std::numbers::pi};  // from rest
  const Built built = build_valid(description);
  const State end = run(built, settings("rattle", 4000.0), 0.5);
  const Vec3 pin = velocity_at(built.model.driven_pins[0].motion, 0.5);
  EXPECT_GT(pin.norm(), 1.0);
  const Vec3 d = end.position.at(1) - end.position.at(0);
  EXPECT_NEAR(d.dot(end.velocity.at(1) - pin), 0.0, 1e-11);
}

}  // namespace
}  // namespace taut::test
