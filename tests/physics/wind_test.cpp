// Wind on sheets.

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

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
  description.wind.emplace().velocity = {0.0, 0.0, wind_speed};
  description.wind->density = 1.2;
  description.wind->drag_coefficient = 1.5;
  return description;
}

class WindMethods : public ::testing::TestWithParam<std::string> {
 protected:
  // Links are rigid, or of the stiffness given where the method knows no rigid ones, or none that say the
  // same twice.
  static Built build_for_method(Description description, double stiffness) {
    const Capabilities& can = find_method(GetParam())->can;
    if (!can.rigid || can.chooses_steps) {
      description.sheets[0].properties.stiffness = stiffness;
      description.sheets[0].diagonals->stiffness = stiffness;
    }
    return build_valid(description);
  }

  // euler's links move masses without pushing them unless velocities are derived.
  static Settings settings_for_method(double steps_per_second, double passes = 0.0) {
    Settings how = settings(GetParam(), steps_per_second, passes);
    if (GetParam() == "euler") how.values["velocities"] = std::string("derived");
    return how;
  }
};

// From rest u' = −k u² with k = ρ C A/(2 m), u being the wind as the sail feels it: u = u₀/(1 + k u₀ t). Both
// sides catch it alike.
TEST_P(WindMethods, ASailIsCarriedAlongByTheLawOfDrag) {
  for (const double wind_speed : {5.0, -5.0}) {
    const Built built = build_for_method(sail(wind_speed), 1e4);
    const State end = run(built, settings_for_method(2000.0), 1.0);
    const double felt = wind_speed / (1.0 + 0.9 * 5.0 * 1.0);
    EXPECT_NEAR(linear_momentum(built.model, end).z(), wind_speed - felt, 5e-3 * 5.0);
  }
}

// Still air holds up a level sheet that falls with √(2 m g/(ρ C A)); in a vacuum it would have 19.6 m/s.
TEST_P(WindMethods, ASheetFallsThroughStillAirWithItsTerminalSpeed) {
  Description description = sail(0.0);
  description.gravity = {0.0, 0.0, -9.81};
  const Built built = build_for_method(description, 1e4);
  const State end = run(built, settings_for_method(2000.0), 2.0);
  const double speed = -linear_momentum(built.model, end).z() / free_mass(built.model);
  const double terminal = std::sqrt(2.0 * 1.0 * 9.81 / (1.2 * 1.5 * 1.0));
  EXPECT_NEAR(speed, terminal, 5e-3 * terminal);
}

TEST_P(WindMethods, WindAlongASailDoesNotPushIt) {
  Description description = sail(0.0);
  description.wind->velocity = {3.0, 2.0, 0.0};
  const Built built = build_for_method(description, 1e3);
  EXPECT_LT(fastest_speed(run(built, settings_for_method(600.0), 1.0)), 1e-12);
}

// Two triangles share a mass, and each gives it its push; undamped springs swing a little beyond.
// Methods that correct along the directions of the start of a step can't turn a link as far as this gale does
// in one, and say so.
TEST_P(WindMethods, AGaleDoesNotBlowUpAFeather) {
  constexpr double gale = 300.0;
  Description description = sail(gale);
  description.sheets[0].mass = 1e-4;
  const Built built = build_for_method(description, 0.01);
  State end = built.start;
  const Capabilities& can = find_method(GetParam())->can;
  // Explicit springs answer a stretch a step later, and one step of 1/60 s in this gale stretches them by
  // metres.
  const double rate = can.limit == StepLimit::spring_frequency ? 600.0 : 60.0;
  if (can.chooses_steps) {
    EXPECT_LE(fastest_speed(run(built, settings_for_method(rate), 0.5)), 1.25 * gale);
    return;
  }
  const RunReport report =
      simulate(built.model, end, settings_for_method(rate, 10.0), std::llround(0.5 * rate));
  if (can.limit == StepLimit::sideways_vibration && report.end != RunEnd::none) {
    EXPECT_EQ(report.counts.status, StepStatus::direction_lost);
    EXPECT_EQ(state_hash(end), state_hash(built.start));
    return;
  }
  ASSERT_EQ(report.end, RunEnd::none);
  EXPECT_LE(fastest_speed(end), (can.rigid ? 1.01 : 1.2) * gale);
}

INSTANTIATE_TEST_SUITE_P(Registry, WindMethods, ::testing::ValuesIn(every_method()), case_name);

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

// A scene that is turned as a whole has its gusts turned, too.
TEST(Gusts, TurnWithGravity) {
  Description description;
  description.sheets = {cloth(2, 2)};
  description.wind = WindSpec{};
  description.wind->velocity = {5.0, 0.0, 2.0};
  description.wind->gust = 0.5;
  const Built upright = build_valid(description);
  description.gravity = {0.0, 0.0, -9.81};
  description.wind->velocity = {5.0, -2.0, 0.0};
  const Built turned = build_valid(description);
  for (double t = 0.0; t < 5.0; t += 0.1) {
    const Vec3 wind = wind_at(*upright.model.wind, t);
    EXPECT_LT((wind_at(*turned.model.wind, t) - Vec3(wind.x(), -wind.z(), wind.y())).norm(), 1e-12) << t;
  }
}

}  // namespace
}  // namespace taut::test
