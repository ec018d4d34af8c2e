// Ropes on round solids against formulas: Atwood's machine, Euler's belt, and a winch.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "fixtures.h"
#include "frames/simulation.h"
#include "model/measures.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

constexpr double fall = 9.81;  // m/s²
constexpr double pulley = 0.2, rope_radius = 0.01, leg = 0.8;
constexpr int links = 80;
constexpr double rope_mass = 0.08;  // kg

double rope_length() {
  return 2.0 * leg + std::numbers::pi * (pulley + rope_radius);
}

// Where the rope is, from the end of its left leg over the pulley to that of its right one.
Vec3 along_rope(double way) {
  const double round = pulley + rope_radius;
  if (way < leg) return {-round, way - leg, 0};
  way -= leg;
  if (way > std::numbers::pi * round) return {round, std::numbers::pi * round - way, 0};
  const double angle = std::numbers::pi - way / round;
  return {round * std::cos(angle), round * std::sin(angle), 0};
}

// A rope over a pulley that stays, with a weight at either end.
Description machine(double left, double right, double friction) {
  Description description;
  CapsuleSpec capsule;
  capsule.from = {0, 0, -0.2};
  capsule.to = {0, 0, 0.2};
  capsule.radius = pulley;
  capsule.friction = friction;
  description.capsules = {capsule};
  for (int i = 0; i <= links; ++i) {
    MassSpec mass;
    mass.name = "rope" + std::to_string(i);
    mass.position = along_rope(rope_length() * i / links);
    mass.radius = rope_radius;
    mass.mass = rope_mass / (links + 1) + (i == 0 ? left : i == links ? right : 0.0);
    description.masses.push_back(mass);
    if (i == 0) continue;
    LinkSpec link;
    link.a = "rope" + std::to_string(i - 1);
    link.b = "rope" + std::to_string(i);
    description.links.push_back(link);
  }
  return description;
}

// What the pull at either end makes of a belt that slides without weight, (m₁ − m₂ e^{µφ})/(m₁ + m₂ e^{µφ})
// g, with what the rope weighs: of each leg with its end, more of the one and less of the other as it runs
// over, and half of what lies on the pulley with each. So ẍ = a + γ x, and x = (a/γ)(cosh √γ t − 1).
double way_at(double left, double right, double friction, double time) {
  const double per_metre = rope_mass / rope_length(), hanging = per_metre * leg;
  const double lying = 0.5 * (rope_mass - 2.0 * hanging), hold = std::exp(friction * std::numbers::pi);
  const double inertia = left + hanging + lying + (right + hanging + lying) * hold;
  const double acceleration = fall * (left + hanging - (right + hanging) * hold) / inertia;
  const double growth = fall * per_metre * (1.0 + hold) / inertia;
  return acceleration / growth * (std::cosh(std::sqrt(growth) * time) - 1.0);
}

// The way between three times, twice differenced: what it was when the rope drew tight makes no difference.
void expect_acceleration(double left, double friction, double share) {
  const Built built = build_valid(machine(left, 1.0, friction));
  taut::Run run_of(built.model, built.start, settings("xpbd", 8000.0, 40.0));
  std::array<double, 3> ways{}, expected{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double time = 0.1 + 0.25 * static_cast<double>(i);
    ways[i] = built.start.position.at(0).y() - run_of.at(time)->position.at(0).y();
    expected[i] = way_at(left, 1.0, friction, time);
  }
  const double bend = expected[0] - 2.0 * expected[1] + expected[2];
  EXPECT_NEAR(ways[0] - 2.0 * ways[1] + ways[2], bend, share * bend) << left;
}

TEST(RopesOverSolids, AtwoodsMachine) {
  for (const double left : {1.5, 1.2}) expect_acceleration(left, 0.0, 0.01);
}

TEST(RopesOverSolids, EulersBelt) {
  const double friction = 0.2;  // e^{µπ} = 1.874
  for (const double left : {2.6, 3.4}) expect_acceleration(left, friction, 0.03);
  // Below that it is held; what it creeps is the step's.
  const Built built = build_valid(machine(1.6, 1.0, friction));
  const State held = run(built, settings("xpbd", 4000.0, 40.0), 0.5);
  EXPECT_LT((held.position.at(0) - built.start.position.at(0)).norm(), 0.01);
}

// A drum turns under a rope that hangs from a pin on one side and bears a weight on the other, towards the
// pin: there it leaves e^−µπ of the pull, and rubs with what it takes at the speed of its turn, as long as it
// turns.
TEST(RopesOverSolids, ADrumThatRubsPaysForTheHeat) {
  const double friction = 0.3, rate = 2.0;  // rad/s
  Description description = machine(0.0, 1.0, friction);
  description.masses.front().pinned = true;
  description.capsules.front().moves.rotation =
      RotationSpec{{0, 0, 1}, {}, {}, rate * 180.0 / std::numbers::pi, 0.1};
  const Built built = build_valid(description);
  taut::Run run_of(built.model, built.start, settings("xpbd", 4000.0, 40.0));
  const State before = *run_of.at(0.5);
  const double done = run_of.work().contacts;
  const State after = *run_of.at(1.5);
  EXPECT_LT(position_error(before, after), 1e-3);  // nothing else changes
  const double hanging = rope_mass * (leg / rope_length());
  const double lying = rope_mass - 2.0 * hanging, round = pulley + rope_radius;
  // What lies on the drum is pressed on by its own weight, too: within what it could at most.
  const double power =
      rate * round * (1.0 + hanging + 0.5 * lying) * fall * (1.0 - std::exp(-friction * std::numbers::pi));
  EXPECT_NEAR(run_of.work().contacts - done, power, 0.01 * power);
  EXPECT_LT(energy(built.model, after).total() - energy(built.model, before).total(), 0.01 * power);
}

TEST(RopesOverSolids, AWinchPullsAtItsRadiusTimesItsRate) {
  const Scene scene = scene_called("winch");
  Simulation simulation(scene);
  const std::size_t load = scene.model.masses.size() - 1;
  ASSERT_EQ(scene.model.masses.name[load], "load");
  const double low = simulation.at(1.5)->position.at(load).y(),
               high = simulation.at(4.5)->position.at(load).y();
  const double rate = 120.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR((high - low) / 3.0, (0.15 + 0.012) * rate, 0.01 * 0.162 * rate);
}

}  // namespace
}  // namespace taut::test
