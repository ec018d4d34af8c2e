// Solids that move: what touches them goes along, by as much as friction and rebound say.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "bat.h"
#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

constexpr std::array<const char*, 2> movers{"xpbd", "verlet"};

MassSpec ball_at(const Vec3& place, double radius = 0.05) {
  MassSpec ball;
  ball.name = "ball";
  ball.position = place;
  ball.radius = radius;
  return ball;
}

WaySpec path(std::vector<Knot> knots) {
  WaySpec motion;
  motion.path = std::move(knots);
  return motion;
}

// A tray of 2 m by 2 m whose upper side is at y = 0, and a ball on it.
Description tray(const WaySpec& motion, double friction) {
  Description description;
  BoxSpec box;
  box.centre = {0, -0.1, 0};
  box.size = {2, 0.2, 2};
  box.moves.motion = motion;
  box.friction = friction;
  description.boxes = {box};
  description.masses = {ball_at({0, 0.05, 0})};
  return description;
}

TEST(MovingSolids, ATrayLiftsWhatLiesOnIt) {
  const Built built = build_valid(tray(path({{0.2, {0, -0.1, 0}}, {1.2, {0, 0.4, 0}}}), 0.5));
  for (const std::string method : movers) {
    const State up = run(built, settings(method, 1000.0), 1.6);
    EXPECT_NEAR(up.position.at(0).y(), 0.55, 1e-3) << method;
    EXPECT_LT(deepest_penetration(built.model, up), 1e-3) << method;
  }
}

// Within µ g the tray carries it along, beyond that it slides.
TEST(MovingSolids, FrictionCarriesAlongUpToItsBound) {
  for (const double friction : {0.6, 0.05}) {
    // A swing of 0.2 m at 4 rad/s: 3.2 m/s² at most, a third of g.
    WaySpec swing;
    swing.sinusoid = SinusoidSpec{{0.2, 0, 0}, 4.0, -0.5 * std::numbers::pi};
    const Built built = build_valid(tray(swing, friction));
    const double sticks = 0.2 * std::sin(4.0 * 1.5 - 0.5 * std::numbers::pi) + 0.2;
    for (const std::string method : movers) {
      const double x = run(built, settings(method, 1000.0), 1.5).position.at(0).x();
      if (friction > 0.5) {
        EXPECT_NEAR(x, sticks, 2e-3) << method;
      } else {
        EXPECT_GT(std::abs(x - sticks), 0.05) << method;
      }
    }
  }
}

// On a belt that starts at a speed, friction takes v/(µ g) to bring it up to that, over v²/(2 µ g).
TEST(MovingSolids, ABeltBringsUpToItsSpeed) {
  Description description;
  PlaneSpec belt;
  belt.friction = 0.2;
  belt.moves.motion =
      path({{0.0, {-2, 0, 0}}, {1.0, {0, 0, 0}}, {2.0, {2, 0, 0}}, {3.0, {4, 0, 0}}, {4.0, {6, 0, 0}}});
  description.planes = {belt};
  description.masses = {ball_at({0, 0.05, 0})};
  const Built built = build_valid(description);
  for (const std::string method : movers) {
    taut::Run run(built.model, built.start, settings(method, 2000.0));
    // From 1 s to 3 s the belt goes at 2 m/s; by then the ball has long come up to it.
    const State at = *run.at(2.5);
    EXPECT_NEAR(at.velocity.at(0).x(), 2.0, 0.01) << method;
    // Before that it gains 0.2 g, from when the belt outruns it.
    EXPECT_EQ(run.failure(), "");
  }
}

TEST(MovingSolids, ATurningPlateCarriesRound) {
  Description description;
  BoxSpec plate;
  plate.moves.name = "plate";
  plate.centre = {0, -0.1, 0};
  plate.size = {2, 0.2, 2};
  plate.friction = 1.0;
  plate.moves.rotation = RotationSpec{{0, 1, 0}, {}, {}, 90.0, 0.5};
  description.boxes = {plate};
  description.masses = {ball_at({0.4, 0.05, 0})};
  const Built built = build_valid(description);
  const double angle = 0.5 * std::numbers::pi * (2.0 - 0.25);
  for (const std::string method : movers) {
    const State state = run(built, settings(method, 1000.0), 2.0);
    const Vec3 expected(0.4 * std::cos(angle), 0.05, -0.4 * std::sin(angle));
    EXPECT_LT((state.position.at(0) - expected).norm(), 4e-3) << method;
  }
}

// A wall that comes at speed w throws what rests before it off with (1 + e) w.
TEST(MovingSolids, ReboundIsAsSeenFromTheSolid) {
  Description description = flying_bat();
  description.masses = {ball_at({0.5, 0, 0})};
  const Built built = build_valid(description);
  for (const std::string method : movers) {
    const State state = run(built, settings(method, 2000.0), 2.5);
    EXPECT_NEAR(state.velocity.at(0).x(), 1.6, 0.01) << method;
  }
}

// What it gives is no sign of a run that goes off, however little energy there was before.
TEST(MovingSolids, AHardBlowIsNoDivergence) {
  Description description;
  description.gravity = {0, -1e-4, 0};
  BoxSpec bat;
  bat.centre = {-2, 0, 0};
  bat.restitution = 1.0;
  bat.moves.motion = path({{0, {-2, 0, 0}}, {0.1, {-1, 0, 0}}, {0.3, {5, 0, 0}}});
  description.boxes = {bat};
  description.masses = {ball_at({0, 0, 0})};
  const Built built = build_valid(description);
  for (const std::string method : movers) {
    taut::Run hit(built.model, built.start, settings(method, 2000.0));
    const std::optional<State> state = hit.at(0.5);
    ASSERT_TRUE(state) << hit.failure();
    EXPECT_GT(state->velocity.at(0).x(), 20.0) << method;
  }
}

TEST(MovingSolids, EachShapePushes) {
  const WaySpec along = path({{0, {-1, 0, 0}}, {2, {0, 0, 0}}});
  Description description;
  description.gravity = Vec3::Zero();
  description.masses = {ball_at({-0.4, 0, 0})};
  const auto pushed = [&](Description with, double reach) {
    const Built built = build_valid(with);
    for (const std::string method : movers) {
      const State state = run(built, settings(method, 1000.0), 2.0);
      EXPECT_GT(state.position.at(0).x(), reach + 0.05 - 1e-3) << method;
    }
  };
  Description with = description;
  with.planes.emplace_back();
  with.planes.back().point = {-1, 0, 0};
  with.planes.back().normal = Vec3::UnitX();
  with.planes.back().moves.motion = along;
  pushed(with, 0.0);
  with = description;
  with.spheres.emplace_back();
  with.spheres.back().centre = {-1, 0, 0};
  with.spheres.back().radius = 0.3;
  with.spheres.back().moves.motion = along;
  pushed(with, 0.3);
  with = description;
  with.capsules.emplace_back();
  with.capsules.back().from = {-1, -1, 0};
  with.capsules.back().to = {-1, 1, 0};
  with.capsules.back().radius = 0.3;
  with.capsules.back().moves.motion = along;
  pushed(with, 0.3);
  with = description;
  with.boxes.emplace_back();
  with.boxes.back().centre = {-1, 0, 0};
  with.boxes.back().size = {0.6, 1, 1};
  with.boxes.back().moves.motion = along;
  pushed(with, 0.3);
}

TEST(MovingSolids, PlacementsAndTwistsAgree) {
  SolidMotion motion;
  motion.centre = {0.3, -0.2, 0.1};
  motion.axis = Vec3(1, 2, 3).normalized();
  motion.turn = SteadyTurn{2.0, 0.8};
  motion.from = {1, 0, 0};
  motion.way = make_path({{0.1, {1, 0, 0}}, {0.7, {1.5, 1, 0}}, {1.4, {0, 2, 1}}});
  const Vec3 mark(0.9, 0.5, -0.4);
  const Carried carried{mark, motion};
  const double h = 1e-5;
  for (const double t : {0.05, 0.3, 0.75, 1.1, 2.0}) {
    const Vec3 slope = (position_at(carried, t + h) - position_at(carried, t - h)) / (2.0 * h);
    const Vec3 bend = (velocity_at(carried, t + h) - velocity_at(carried, t - h)) / (2.0 * h);
    EXPECT_LT((slope - velocity_at(carried, t)).norm(), 1e-8) << t;
    EXPECT_LT((bend - acceleration_at(carried, t)).norm(), 1e-7) << t;
    const Placement placement = placement_at(motion, t);
    EXPECT_LT((placement.back(placement.place(mark)) - mark).norm(), 1e-14);
  }
}

// A pin that is carried takes part in every method.
TEST(MovingSolids, EveryMethodHasPinsThatAreCarried) {
  Description description;
  SphereSpec drum;
  drum.moves.name = "drum";
  drum.centre = {0, 0, 0};
  drum.radius = 0.1;
  drum.moves.rotation = RotationSpec{{0, 0, 1}, {}, {{{0.0, 0.0}}, {{1.0, 90.0}}}, {}, 0.0};
  description.spheres = {drum};
  ChainSpec chain;
  chain.name = "rope";
  chain.from = {0.5, 0, 0};
  chain.to = {0.5, -1, 0};
  chain.links = 4;
  chain.pinned = {"first"};
  chain.first_motion.with = "drum";
  description.chains = {chain};
  Built built = build_valid(description);
  built.model.colliders.clear();
  built.model.contacts.clear();
  for (const Method& method : all_methods()) {
    if (!capability_problems(built.model, method).empty()) continue;
    Settings chosen = settings(std::string(method.name), 1000.0, 4.0);
    const State state = run(built, chosen, 1.5);
    EXPECT_LT((state.position.at(0) - Vec3(0, 0.5, 0)).norm(), 1e-12) << method.name;
  }
}

TEST(MovingSolids, OnlyMethodsWithSolidsDoThem) {
  const Built built = build_valid(tray(path({{0, {0, -0.1, 0}}, {1, {0, 0.4, 0}}}), 0.5));
  for (const Method& method : all_methods())
    EXPECT_EQ(capability_problems(built.model, method).empty(), method.can.colliders) << method.name;
  Description ground;
  ground.planes.emplace_back();
  ground.planes.back().moves.motion = path({{0, {0, 0, 0}}, {1, {0, 1, 0}}});
  ground.masses = {ball_at({0, 0.05, 0})};
  const Built moving = build_valid(ground);
  EXPECT_FALSE(capability_problems(moving.model, *find_method("euler")).empty());
}

TEST(MovingSolids, WhatCantBeIsRefused) {
  const auto first_problem = [](const Description& description) {
    const Built built = build(description);
    return built.problems.empty() ? std::string()
                                  : built.problems.front().section + ": " + built.problems.front().message;
  };
  Description description = tray(path({{0, {0, -0.1, 0}}, {1, {0, 0.4, 0}}}), 0.5);
  description.masses.front().position.y() = -0.05;
  EXPECT_EQ(first_problem(description), "box: it moves, and at the start \"ball\" is 0.1 m inside it");
  description = tray(path({{0, {0, -0.1, 0}}, {1e-9, {0, 0.4, 0}}}), 0.5);
  EXPECT_EQ(first_problem(description),
            "box: motion: between 0 s and 1e-09 s the path goes 0.5 m, at 5e+08 m/s: that is a jump");
  description = tray({}, 0.5);
  description.boxes.front().moves.rotation = RotationSpec{{0, 0, 0}, {}, {}, 90.0, 0.0};
  EXPECT_EQ(first_problem(description), "box: rotation: axis must not be zero");
  description.boxes.front().moves.rotation = RotationSpec{{0, 1, 0}, {}, {}, {}, 0.0};
  EXPECT_EQ(first_problem(description),
            "box: rotation needs either a \"rate\", or \"angle\", a list of [time, degrees]");
  description.boxes.front().moves.rotation =
      RotationSpec{{0, 1, 0}, {}, {{{1.0, 0.0}}, {{0.5, 9.0}}}, {}, 0.0};
  EXPECT_EQ(first_problem(description), "box: rotation: times of \"angle\" must increase");
  description = tray({}, 0.5);
  description.boxes.front().moves.name = "tray";
  description.masses.front().pinned = true;
  description.masses.front().motion.with = "trey";
  EXPECT_EQ(first_problem(description), "mass: no solid is named \"trey\"");
  EXPECT_EQ(build(description).problems.front().suggestion, "tray");
}

}  // namespace
}  // namespace taut::test
