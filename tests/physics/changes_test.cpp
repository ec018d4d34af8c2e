// What happens at a time: links that break, pins that let go, loads that end; and seams, where nets give way.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

std::vector<std::string> methods_that_take(const Model& model) {
  std::vector<std::string> names;
  for (const Method& method : all_methods())
    if (capability_problems(model, method).empty()) names.emplace_back(method.name);
  return names;
}

SeamSpec between(std::vector<std::string> a, std::vector<std::string> b) {
  SeamSpec seam;
  seam.a = std::move(a);
  seam.b = std::move(b);
  return seam;
}

SeamSpec in_sheet(std::string name, std::optional<int> row, std::optional<int> column = {}) {
  SeamSpec seam;
  seam.sheet = std::move(name);
  seam.row = row;
  seam.column = column;
  return seam;
}

SeamSpec opening_at(SeamSpec seam, double time) {
  seam.break_at = time;
  return seam;
}

SeamSpec as_strong_as(SeamSpec seam, double strength) {
  seam.strength = strength;
  return seam;
}

// A rope that hangs, of springs or rigid.
Description hanging(bool springs) {
  Description description;
  ChainSpec rope;
  rope.name = "rope";
  rope.to = {0, -1, 0};
  rope.links = 4;
  rope.pinned = {"first"};
  if (springs) rope.properties.stiffness = 2000.0;
  description.chains = {rope};
  return description;
}

Vec3 mean(const Vectors& of) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < of.size(); ++i) sum += of.at(i);
  return sum / static_cast<double>(of.size());
}

TEST(Changes, ALinkBreaksAtItsTime) {
  for (const bool springs : {false, true}) {
    Description description = hanging(springs);
    description.seams = {opening_at(between({"rope.1"}, {"rope.2"}), 0.3217)};
    const Built built = build_valid(description);
    for (const std::string& method : methods_that_take(built.model)) {
      const State state = run(built, settings(method, 1000.0, 4.0), 0.5);
      EXPECT_NEAR(state.broken_at[1], 0.3217, 1e-12) << method;
      EXPECT_EQ(broken_links(state), 1U) << method;
      if (method == "euler" || springs) continue;
      const double fallen = 0.5 * 9.81 * std::pow(0.5 - 0.3217, 2);
      EXPECT_NEAR(state.position.at(4).y(), -1.0 - fallen, 2e-3) << method;
    }
  }
}

// From then on its centre of mass, the freed one among them, is in free fall.
TEST(Changes, APinLetsGoAtItsTime) {
  for (const bool springs : {false, true}) {
    Description description = hanging(springs);
    description.chains.front().first_release = 0.2503;
    const Built built = build_valid(description);
    for (const std::string& method : methods_that_take(built.model)) {
      if (method == "euler") continue;  // whose velocities have grown while it hung
      taut::Run run_of(built.model, built.start, settings(method, 1000.0, 4.0));
      EXPECT_EQ(run_of.at(0.25)->position.at(0).norm(), 0.0) << method;
      const State let_go = run_of.reported(*run_of.at(0.2503)), later = *run_of.at(0.6);
      EXPECT_EQ(run_of.failure(), "") << method;
      const double time = 0.6 - 0.2503;
      const Vec3 expected =
          mean(let_go.position) + time * mean(let_go.velocity) - (0.5 * 9.81 * time * time) * Vec3::UnitY();
      EXPECT_LT((mean(later.position) - expected).norm(), 3e-3) << method << springs;
      EXPECT_LT(later.position.at(0).y(), -0.2) << method;
    }
  }
}

// What the masses gain after the release is no error of the method: its energy is accounted for.
TEST(Changes, TheLedgerKnowsOfWhatIsLetGo) {
  Description description = hanging(false);
  description.chains.front().first_release = 0.25;
  description.chains.front().first_motion.path = {{0.0, {0, 0, 0}}, {0.5, {0.2, 0.1, 0}}};
  const Built built = build_valid(description);
  for (const std::string method : {"rattle", "dop853", "shake"}) {
    taut::Run run_of(built.model, built.start, settings(method, 2000.0, 20.0));
    const State state = *run_of.at(0.8);
    EXPECT_EQ(run_of.failure(), "");
    EXPECT_LT(std::abs(run_of.measures(state).energy_error), 2e-3) << method;
  }
}

TEST(Changes, AResumedRunIsTheSame) {
  Description description = hanging(false);
  description.chains.front().first_release = 0.25;
  description.seams = {opening_at(between({"rope.2"}, {"rope.3"}), 0.4)};
  const Built built = build_valid(description);
  for (const std::string& method : methods_that_take(built.model)) {
    const Settings chosen = settings(method, 600.0, 4.0);
    taut::Run whole(built.model, built.start, chosen);
    const std::uint64_t expected = state_hash(*whole.at(0.7));
    for (const double stop : {0.1, 0.25, 0.3, 0.4, 0.55}) {
      taut::Run first(built.model, built.start, chosen);
      const std::optional<RunState> saved = first.save_before(stop);
      ASSERT_TRUE(saved) << method;
      taut::Run rest(built.model, built.start, chosen, *saved);
      EXPECT_EQ(state_hash(*rest.at(0.7)), expected) << method << stop;
    }
  }
}

TEST(Changes, ALoadEnds) {
  Load load{{}, Vec3::UnitX(), 1.0, 2.0, 3.0, 5.0};
  EXPECT_EQ(load.share(0.5), 0.0);
  EXPECT_EQ(load.share(1.5), 0.5);
  EXPECT_EQ(load.share(2.5), 1.0);
  EXPECT_EQ(load.share(4.0), 0.5);
  EXPECT_EQ(load.share(6.0), 0.0);
  EXPECT_EQ((Load{{}, Vec3::UnitX(), 1.0, 1.0}).share(100.0), 1.0);
  EXPECT_EQ((Load{{}, Vec3::UnitX(), 0.0, 0.0, 2.0, 2.0}).share(2.0), 0.0);
  Description description;
  description.gravity = Vec3::Zero();
  MassSpec mass;
  mass.name = "m";
  description.masses = {mass};
  LoadSpec push;
  push.masses = {"m"};
  push.force = {1, 0, 0};
  push.until = 0.5;
  description.loads = {push};
  const Built built = build_valid(description);
  for (const std::string method : {"verlet", "rattle", "dop853"})
    EXPECT_NEAR(run(built, settings(method, 1000.0), 1.0).velocity.at(0).x(), 0.5, 2e-3) << method;
}

Description torn_sheet(const SeamSpec& seam) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = 8;
  sheet.columns = 9;
  sheet.to = {0.8, 0, 0};
  sheet.down = {0, -0.7, 0};
  sheet.pinned = {"top"};
  sheet.properties = {2000.0, 1.0, 1.5, {}};
  sheet.diagonals = LinkProperties{200.0, 0.1, 1.5, {}};
  sheet.skip_one = LinkProperties{50.0, 0.1, {}, {}};
  description.sheets = {sheet};
  LoadSpec pull;
  pull.masses = {"cloth.7.*"};
  pull.force = {0, -35, 0};
  pull.to = 1.0;
  description.loads = {pull};
  description.seams = {seam};
  description.drag = 0.5;
  return description;
}

TEST(Seams, ATearFollowsItsSeam) {
  const Built built = build_valid(torn_sheet(as_strong_as(in_sheet("cloth", 3), 0.2)));
  for (const std::string method : {"xpbd", "spring-implicit"}) {
    const State state = run(built, settings(method, 600.0, 4.0), 1.5);
    std::size_t across = 0, beside = 0;
    for (std::size_t i = 0; i < built.model.links.size(); ++i) {
      if (!state.broken(i)) continue;
      const bool crosses = (built.model.links.a[i] / 9 <= 3) != (built.model.links.b[i] / 9 <= 3);
      ++(crosses ? across : beside);
    }
    EXPECT_GE(across, 9U) << method;  // one in each column
    EXPECT_EQ(beside, 0U) << method;
  }
}

TEST(Seams, ALineOfASheetIsAllThatCrossesIt) {
  const Built built = build_valid(torn_sheet(opening_at(in_sheet("cloth", {}, 4), 0.5)));
  ASSERT_EQ(built.model.changes.size(), 1U);
  // 8 along rows, 14 diagonals, 2 × 8 that skip one.
  EXPECT_EQ(built.model.changes.front().links.size(), 8U + 14U + 16U);
  const State state = run(built, settings("xpbd", 600.0, 4.0), 1.0);
  EXPECT_EQ(broken_links(state), 38U);
}

TEST(Seams, ThresholdsScatterBySeed) {
  Description description = hanging(true);
  LinkProperties& properties = description.chains.front().properties;
  properties.break_tension = 100.0;
  properties.break_stretch = 1.5;
  properties.scatter = 0.2;
  const Links first = build_valid(description).model.links, again = build_valid(description).model.links;
  properties.scatter_seed = 2;
  const Links other = build_valid(description).model.links;
  EXPECT_EQ(first.break_tension, again.break_tension);
  EXPECT_NE(first.break_tension, other.break_tension);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_GE(first.break_tension[i], 80.0);
    EXPECT_LE(first.break_tension[i], 120.0);
    EXPECT_NE(first.break_tension[i], 100.0);
    EXPECT_NEAR((first.break_stretch[i] - 1.0) / 0.5, first.break_tension[i] / 100.0, 1e-12);
  }
}

TEST(Seams, WhatCantBeIsRefused) {
  const auto first_problem = [](const SeamSpec& seam) {
    const Built built = build(torn_sheet(seam));
    if (built.problems.empty()) return std::string();
    const Problem& problem = built.problems.front();
    return problem.key + ": " + problem.message +
           (problem.suggestion.empty() ? "" : "?" + problem.suggestion);
  };
  EXPECT_EQ(first_problem(as_strong_as(in_sheet("clot", 3), 0.2)), "sheet: no sheet is named \"clot\"?cloth");
  EXPECT_EQ(first_problem(as_strong_as(in_sheet("cloth", 7), 0.2)),
            "row: the seam lies beyond line 7, and \"cloth\" has lines 0 to 7: from 0 to 6 there is one");
  EXPECT_EQ(first_problem(as_strong_as(in_sheet("cloth", {}), 0.2)),
            "row: a seam in a sheet needs either a \"row\" or a \"column\"");
  EXPECT_EQ(first_problem(as_strong_as(between({"cloth.0.0"}, {"cloth.5.5"}), 0.2)),
            ": no link lies across the seam");
  EXPECT_EQ(first_problem(as_strong_as(between({"cloth.0.99"}, {"cloth.5.5"}), 0.2)).substr(0, 38),
            "a: no mass is named \"cloth.0.99\"?cloth");
  EXPECT_EQ(first_problem(in_sheet("cloth", 3)),
            "strength: a seam needs a \"strength\", a threshold, or a \"break_at\"");
  SeamSpec doubly = as_strong_as(in_sheet("cloth", 3), 0.5);
  doubly.break_tension = 2.0;
  EXPECT_EQ(
      first_problem(doubly),
      "strength: strength is a share of what links bear otherwise; with a threshold of its own a seam has "
      "none");
}

}  // namespace
}  // namespace taut::test
