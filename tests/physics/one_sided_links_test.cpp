// Links that only pull, only push, or hold between two lengths: free flight where they do nothing, the moment
// at which they act, and what they carry then.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

constexpr double pull_of_earth = 9.81;  // m/s²

// A mass of 2 kg at a place with a velocity, and its link of 1 m to a pin at the origin.
Description tied(LinkAction acts, const Vec3& place, const Vec3& velocity = Vec3::Zero()) {
  Description description;
  MassSpec pin, mass;
  pin.name = "pin";
  pin.pinned = true;
  mass.name = "mass";
  mass.position = place;
  mass.velocity = velocity;
  mass.mass = 2.0;
  description.masses = {pin, mass};
  LinkSpec link;
  link.a = "pin";
  link.b = "mass";
  link.length = 1.0;
  link.properties.acts = acts;
  if (acts == LinkAction::between) link.properties.longest = 1.5;
  description.links = {link};
  return description;
}

Description soft(Description description, double stiffness) {
  description.links.front().properties.stiffness = stiffness;
  return description;
}

std::vector<std::string> methods_for(const Model& model) {
  std::vector<std::string> names;
  for (const Method& method : all_methods())
    if (capability_problems(model, method).empty()) names.emplace_back(method.name);
  return names;
}

Settings fine(const std::string& method) {
  Settings chosen = settings(method, 2000.0, 4.0);
  if (method == "dop853") chosen.values["tolerance"] = 1e-10;
  if (method == "euler") chosen.values["velocities"] = "derived";
  return chosen;
}

TEST(OneSidedLinks, EveryMethodDoesThemOrSaysSo) {
  EXPECT_EQ(methods_for(build_valid(tied(LinkAction::pull, {0, -1, 0})).model),
            (std::vector<std::string>{"euler", "verlet", "xpbd", "shake", "rattle", "dop853", "newton"}));
  EXPECT_EQ(methods_for(build_valid(soft(tied(LinkAction::pull, {0, -1, 0}), 100.0)).model),
            (std::vector<std::string>{"xpbd", "shake", "rattle", "dop853", "newton", "spring-explicit",
                                      "spring-implicit"}));
}

TEST(OneSidedLinks, ASlackRopeDoesNothing) {
  const Built built = build_valid(tied(LinkAction::pull, {0.1, -0.4, 0.2}, {0.3, 0.0, 0.0}));
  for (const std::string& method : methods_for(built.model)) {
    const State state = run(built, fine(method), 0.25);
    const Vec3 expected =
        Vec3(0.1, -0.4, 0.2) + 0.25 * Vec3(0.3, 0, 0) - 0.5 * pull_of_earth * 0.0625 * Vec3::UnitY();
    EXPECT_LT((state.position.at(1) - expected).norm(), 2e-3) << method;
    EXPECT_EQ(state.tension[0], 0.0) << method;
    EXPECT_EQ(link_strain(built.model, state).largest, 0.0) << method;
  }
}

TEST(OneSidedLinks, ARopeThatHangsCarriesTheWeight) {
  const Built built = build_valid(tied(LinkAction::pull, {0, -1, 0}));
  for (const std::string& method : methods_for(built.model)) {
    const State state = run(built, fine(method), 0.5);
    EXPECT_NEAR(state.position.at(1).y(), -1.0, 1e-4) << method;
    if (find_method(method)->can.tension_order > 0) {
      EXPECT_NEAR(state.tension[0], 2.0 * pull_of_earth, 0.01 * pull_of_earth) << method;
    }
  }
}

// It falls until the rope is taut, loses what goes along it, and swings on.
TEST(OneSidedLinks, AFallEndsWhereTheRopeIsTaut) {
  const Built built = build_valid(tied(LinkAction::pull, {0.6, 0.0, 0.0}));
  const double taut_at = std::sqrt(2.0 * 0.8 / pull_of_earth), speed = pull_of_earth * taut_at;
  // At (0.6, −0.8) the direction across the rope is (−0.8, −0.6): 0.6 of the speed is kept, and what it is
  // worth with the height decides how far the swing goes.
  const double energy = 0.5 * 0.36 * speed * speed - pull_of_earth * 0.8;  // over mass
  const auto energy_of = [&](const State& state) {
    return 0.5 * state.velocity.at(1).squaredNorm() + pull_of_earth * state.position.at(1).y();
  };
  for (const std::string& method : methods_for(built.model)) {
    const State before = run(built, fine(method), 0.4), after = run(built, fine(method), 0.6);
    EXPECT_NEAR(before.position.at(1).y(), -0.5 * pull_of_earth * 0.16, 5e-3) << method;
    EXPECT_NEAR(after.position.at(1).norm(), 1.0, 1e-3) << method;
    if (method == "euler") continue;  // whose velocities are not those of its order
    EXPECT_NEAR(energy_of(after), energy, method == "dop853" ? 1e-6 : 0.12) << method;
  }
}

TEST(OneSidedLinks, ADirectionalBufferHoldsUpAndLetsGo) {
  const Built built = build_valid(tied(LinkAction::push, {0.0, 1.0, 0.0}, {0.0, 2.0, 0.0}));
  for (const std::string& method : methods_for(built.model)) {
    const State high = run(built, fine(method), 0.2), landed = run(built, fine(method), 1.0);
    EXPECT_NEAR(high.position.at(1).y(), 1.0 + 0.4 - 0.5 * pull_of_earth * 0.04, 5e-3) << method;
    EXPECT_NEAR(landed.position.at(1).y(), 1.0, 1e-3) << method;
    if (find_method(method)->can.tension_order > 0) {
      EXPECT_NEAR(landed.tension[0], -2.0 * pull_of_earth, 0.02 * pull_of_earth) << method;
    }
  }
}

TEST(OneSidedLinks, BetweenTwoLengthsItIsFree) {
  const Built up = build_valid(tied(LinkAction::between, {0.0, 1.2, 0.0}));
  const Built down = build_valid(tied(LinkAction::between, {0.0, -1.2, 0.0}));
  for (const std::string& method : methods_for(up.model)) {
    EXPECT_NEAR(run(up, fine(method), 0.1).position.at(1).y(), 1.2 - 0.5 * pull_of_earth * 0.01, 5e-3)
        << method;
    EXPECT_NEAR(run(up, fine(method), 1.0).position.at(1).y(), 1.0, 1e-3) << method;
    EXPECT_NEAR(run(down, fine(method), 1.0).position.at(1).y(), -1.5, 1e-3) << method;
  }
}

// m g (1 + x) = k x²/2 at the lowest point of a fall of 1 m into the rope.
TEST(OneSidedLinks, ABungeeReachesAsFarAsItsEnergySays) {
  Description description = soft(tied(LinkAction::pull, {0, -1e-3, 0}), 200.0);
  const Built built = build_valid(description);
  const double weight = 2.0 * pull_of_earth, k = 200.0;
  const double lowest = -1.0 - (weight + std::sqrt(weight * weight + 2.0 * k * weight * (1.0 - 1e-3))) / k;
  for (const std::string& method : methods_for(built.model)) {
    taut::Run run(built.model, built.start, fine(method));
    double reached = 0.0;
    for (int i = 1; i <= 400; ++i) reached = std::min(reached, run.at(i * 0.0025)->position.at(1).y());
    EXPECT_EQ(run.failure(), "") << method;
    EXPECT_NEAR(reached, lowest, method == "dop853" ? 1e-4 : 0.01) << method;
    EXPECT_EQ(run.at(1.3)->tension[0], 0.0) << method;  // thrown up again, and slack
  }
}

// The moment at which a rope is taut is found: the error of a method that cuts its steps there has no part of
// first order in it.
TEST(OneSidedLinks, TheAccurateEndMeetsTheMoment) {
  const Built built = build_valid(tied(LinkAction::pull, {0, -0.5, 0}, {0.2, 0, 0}));
  const State loose = accurately(built.model, built.start, {0.9}, 1e-8).front();
  const State tight = accurately(built.model, built.start, {0.9}, 1e-12).front();
  EXPECT_LT(position_error(loose, tight), 1e-7);
}

Description rope(LinkAction acts, std::optional<double> stiffness = {}) {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.from = {0, 0, 0};
  chain.to = {1.2, 0, 0};
  chain.length = 1.5;
  chain.links = 12;
  chain.pinned = {"first", "last"};
  chain.properties.acts = acts;
  chain.properties.stiffness = stiffness;
  description.chains = {chain};
  description.drag = 3.0;
  return description;
}

TEST(OneSidedLinks, ARopeBetweenPinsHangsLikeAChain) {
  for (const std::string method : {"xpbd", "verlet", "shake", "rattle", "dop853", "newton"}) {
    Settings chosen = settings(method, 600.0, 10.0);
    const State chain = run(build_valid(rope(LinkAction::both)), chosen, 3.0);
    const State pulled = run(build_valid(rope(LinkAction::pull)), chosen, 3.0);
    EXPECT_LT(position_error(chain, pulled), 2e-4) << method;
  }
}

// However hard it is shaken, and however its links let go of one another within a step.
TEST(OneSidedLinks, NoRopePushes) {
  Description description = rope(LinkAction::pull);
  description.drag = 0.0;
  description.chains.front().first_motion.sinusoid = SinusoidSpec{{0.1, 0.2, 0.0}, 12.0, 0.0};
  const Built built = build_valid(description);
  for (const std::string method : {"xpbd", "verlet", "shake", "rattle", "newton"}) {
    taut::Run shaken(built.model, built.start, settings(method, 1200.0, 10.0));
    double least = 0.0, most = 0.0;
    for (int frame = 1; frame <= 120; ++frame) {
      const std::optional<State> state = shaken.at(frame / 60.0);
      ASSERT_TRUE(state) << shaken.failure();
      least = std::min(least, *std::ranges::min_element(state->tension));
      most = std::max(most, *std::ranges::max_element(state->tension));
    }
    EXPECT_GE(least, 0.0) << method;
    EXPECT_GT(most, 5.0) << method;
  }
}

TEST(OneSidedLinks, ItBreaksByStretchAndByTension) {
  for (const bool by_tension : {false, true}) {
    Description description = soft(tied(LinkAction::pull, {0, -0.9, 0}), 500.0);
    LinkProperties& link = description.links.front().properties;
    (by_tension ? link.break_tension : link.break_stretch) = by_tension ? 25.0 : 1.05;  // 25 N either way
    const Built built = build_valid(description);
    for (const std::string& method : methods_for(built.model)) {
      const State state = run(built, fine(method), 1.0);
      ASSERT_TRUE(state.broken(0)) << method << by_tension;
      EXPECT_GT(state.broken_at[0], 0.14) << method;
      EXPECT_LT(state.broken_at[0], 0.30) << method;
      const Vec3 velocity = state.velocity.at(1);
      const State later = run(built, fine(method), 1.1);
      EXPECT_NEAR(later.velocity.at(1).y(), velocity.y() - 0.1 * pull_of_earth, 0.02) << method;
    }
  }
}

TEST(OneSidedLinks, WhatCantBeIsRefused) {
  const auto first_problem = [](const Description& description) {
    const Built built = build(description);
    return built.problems.empty() ? std::string()
                                  : built.problems.front().key + ": " + built.problems.front().message;
  };
  EXPECT_EQ(first_problem(tied(LinkAction::pull, {0, -1.25, 0})),
            "acts: at the start \"pin\" and \"mass\" are 1.25 m apart, and their link, which is rigid, lets "
            "them be "
            "1 m at most");
  EXPECT_EQ(
      first_problem(tied(LinkAction::push, {0, 0.5, 0})),
      "acts: at the start \"pin\" and \"mass\" are 0.5 m apart, and their link, which is rigid, lets them be "
      "1 m at least");
  EXPECT_EQ(first_problem(soft(tied(LinkAction::pull, {0, -1.25, 0}), 10.0)), "");
  Description description = tied(LinkAction::between, {0, -1, 0});
  description.links.front().properties.longest.reset();
  EXPECT_EQ(first_problem(description), "longest: a link that acts \"between\" needs the key \"longest\"");
  description = tied(LinkAction::pull, {0, -1, 0});
  description.links.front().properties.longest = 1.5;
  EXPECT_EQ(first_problem(description),
            "longest: longest is only for links that act \"between\" two lengths");
  description = soft(tied(LinkAction::pull, {0, -1, 0}), 10.0);
  description.links.front().properties.damping = 1.0;
  EXPECT_EQ(first_problem(description), "damping: damping is only for links that act both ways");
}

TEST(OneSidedLinks, TooManyForADirectSolveAreRefused) {
  Description description = rope(LinkAction::pull);
  description.chains.front().links = 1200;
  const Built built = build_valid(description);
  EXPECT_EQ(methods_for(built.model), (std::vector<std::string>{"euler", "verlet", "xpbd", "shake"}));
}

}  // namespace
}  // namespace taut::test
