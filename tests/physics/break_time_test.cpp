// A pendulum released level carries 3 m g sin(angle below level): with break_tension T it breaks at
// sin(angle) = T/(3 m g), and then flies the parabola.

#include "fixtures.h"
#include "measure/exact.h"

namespace taut::test {
namespace {

class BreaksByTension : public ::testing::TestWithParam<std::string> {};

constexpr double break_tension = 20.0;
const double exact_angle = std::asin(break_tension / (3.0 * 9.81));

// When the pendulum passes that angle, by bisection of the exact motion.
double exact_break_time() {
  double low = 0.0, high = 0.59;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (pendulum_angle_below_level(1.0, 9.81, middle) < exact_angle ? low : high) = middle;
  }
  return low;
}

State end_of(const std::string& method, double rate) {
  Description description = pendulum();
  description.links[0].properties.break_tension = break_tension;
  return run(build_valid(description), settings(method, rate, 40.0), 0.8);
}

TEST_P(BreaksByTension, TimeOfTheBreakConverges) {
  const double exact = exact_break_time();
  double last = 1.0;
  for (const double rate : {500.0, 2000.0, 8000.0}) {
    const double error = std::abs(end_of(GetParam(), rate).broken_at[0] - exact);
    EXPECT_LT(error, 3.0 / rate) << rate << " steps/s: it broke " << error << " s from " << exact << " s";
    EXPECT_LT(error, std::max(last, 1e-14));
    last = error;
  }
}

TEST_P(BreaksByTension, FliesTheParabolaAfterwards) {
  const double t = exact_break_time(), flight = 0.8 - t;
  const double speed = std::sqrt(2.0 * 9.81 * std::sin(exact_angle));
  const Vec3 velocity = speed * Vec3(-std::sin(exact_angle), -std::cos(exact_angle), 0.0);
  const Vec3 exact = Vec3(std::cos(exact_angle), -std::sin(exact_angle), 0.0) + flight * velocity +
                     0.5 * flight * flight * Vec3(0.0, -9.81, 0.0);
  EXPECT_LT((end_of(GetParam(), 16000.0).position.at(1) - exact).norm(), 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Registry, BreaksByTension,
                         ::testing::ValuesIn(methods_that([](const Capabilities& can) {
                           return can.rigid && can.break_tension;
                         })),
                         case_name);

}  // namespace
}  // namespace taut::test
