// Wind on sheets.

#include "fixtures.h"
#include "measure/measures.h"

namespace taut::test {
namespace {

std::vector<std::string> wind_methods() {
  return methods_that([](const Capabilities& can) { return can.wind; });
}

// A free sheet of one cell, 1 m², 1 kg, that faces along z, without gravity.
Description sail(double wind_speed) {
  Description description;
  description.gravity = Vec3::Zero();
  SheetSpec sheet;
  sheet.name = "sail";
  sheet.to = {1.0, 0.0, 0.0};
  sheet.down = {0.0, -1.0, 0.0};
  sheet.diagonals = LinkProperties{};
  description.sheets = {sheet};
  description.wind.velocity = {0.0, 0.0, wind_speed};
  description.wind.density = 1.2;
  description.wind.drag_coefficient = 1.5;
  return description;
}

class WindMethods : public ::testing::TestWithParam<std::string> {};

// From rest u' = −k u² with k = ρ C A/(2 m), u being the wind as the sail feels it: u = u₀/(1 + k u₀ t). Both
// sides catch it alike.
TEST_P(WindMethods, ASailIsCarriedAlongByTheLawOfDrag) {
  for (const double wind_speed : {5.0, -5.0}) {
    const Built built = build_valid(sail(wind_speed));
    const State end = run(built, settings(GetParam(), 2000.0), 1.0);
    const double felt = wind_speed / (1.0 + 0.9 * 5.0 * 1.0);
    EXPECT_NEAR(linear_momentum(built.model, end).z(), wind_speed - felt, 5e-3 * 5.0);
  }
}

TEST_P(WindMethods, WindAlongASailDoesNotPushIt) {
  Description description = sail(0.0);
  description.wind.velocity = {3.0, 2.0, 0.0};
  const Built built = build_valid(description);
  EXPECT_LT(fastest_speed(run(built, settings(GetParam(), 600.0), 1.0)), 1e-12);
}

TEST_P(WindMethods, AGaleDoesNotBlowUpAFeather) {
  Description description = sail(300.0);
  description.sheets[0].mass = 1e-4;
  const Built built = build_valid(description);
  const State end = run(built, settings(GetParam(), 60.0, 10.0), 0.5);
  EXPECT_LE(fastest_speed(end), 1.01 * 300.0) << "two triangles share a mass, and each gives it its push";
}

INSTANTIATE_TEST_SUITE_P(Registry, WindMethods, ::testing::ValuesIn(wind_methods()), case_name);

TEST(Gusts, AreAFunctionOfTimeAndSeed) {
  Wind wind;
  wind.velocity = {10.0, 0.0, 0.0};
  wind.gust = 0.4;
  Wind other = wind;
  other.seed = 2;
  double least = infinity, most = -infinity, difference = 0.0, jump = 0.0;
  for (double t = 0.0; t < 60.0; t += 0.01) {
    const double speed = wind_at(wind, t).x();
    least = std::min(least, speed);
    most = std::max(most, speed);
    difference = std::max(difference, std::abs(speed - wind_at(other, t).x()));
    jump = std::max(jump, std::abs(wind_at(wind, t + 1e-6).x() - speed));
    EXPECT_EQ(wind_at(wind, t), wind_at(wind, t));
  }
  EXPECT_GE(least, 6.0);
  EXPECT_LE(most, 14.0);
  EXPECT_GT(most - least, 3.0);
  EXPECT_GT(difference, 1.0);
  EXPECT_LT(jump, 1e-3);
  wind.gust = 0.0;
  EXPECT_EQ(wind_at(wind, 3.3), wind.velocity);
}

}  // namespace
}  // namespace taut::test
