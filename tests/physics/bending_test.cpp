// Bending stiffness against the elastica, against Peirce's test of cloth, and along warp, weft and bias.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

// A rod of length 1 m and stiffness EI (N m²), clamped level at the origin and loaded at its tip, without
// weight. The clamp is in the middle of the link between the two pins: so a bend of EI/l at the second pin
// stands for the half of a link on either side of it.
Description cantilever(int links, double rigidity, double load, std::optional<double> stretch_stiffness) {
  const double length = 1.0 / (links + 0.5);  // of a link: links + ½ of them are free
  Description description;
  description.gravity = Vec3::Zero();
  description.drag = 8.0;
  ChainSpec rod;
  rod.name = "rod";
  rod.from = {-0.5 * length, 0, 0};
  rod.to = {1.0, 0, 0};
  rod.links = links + 1;
  rod.mass = 0.1;
  rod.pinned = {"first"};
  rod.properties.stiffness = stretch_stiffness;
  rod.bending = BendingSpec{rigidity / length, false};
  description.chains = {rod};
  LoadSpec tip;
  tip.masses = {"rod." + std::to_string(links + 1)};
  tip.force = {0, -load, 0};
  tip.to = 0.5;
  description.loads = {tip};
  return description;
}

// The second mass is held, too.
Built clamped(const Description& description) {
  Built built = build_valid(description);
  built.model.masses.inverse_mass[1] = 0.0;
  return built;
}

// The elastica: EI θ'' = −P cos θ with θ(0) = 0, θ'(1) = 0, by shooting for θ'(0) with steps of fourth order.
// Returns the height that the tip comes to, and how far it comes in (m).
std::array<double, 2> elastica(double load_over_rigidity) {
  std::array<double, 2> tip{};
  const auto shoot = [&](double curvature) {
    constexpr int steps = 2000;
    const double h = 1.0 / steps;
    double angle = 0.0, x = 0.0, y = 0.0;
    for (int i = 0; i < steps; ++i) {
      const auto bent = [&](double at) { return -load_over_rigidity * std::cos(at); };
      const double k1 = curvature, c1 = bent(angle);
      const double k2 = curvature + 0.5 * h * c1, c2 = bent(angle + 0.5 * h * k1);
      const double k3 = curvature + 0.5 * h * c2, c3 = bent(angle + 0.5 * h * k2);
      const double k4 = curvature + h * c3, c4 = bent(angle + h * k3);
      const double middle = angle + 0.5 * h * k2, next = angle + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
      x += h / 6.0 * (std::cos(angle) + 4.0 * std::cos(middle) + std::cos(next));
      y += h / 6.0 * (std::sin(angle) + 4.0 * std::sin(middle) + std::sin(next));
      angle = next;
      curvature += h / 6.0 * (c1 + 2.0 * c2 + 2.0 * c3 + c4);
    }
    tip = {-y, 1.0 - x};
    return curvature;
  };
  double low = 0.0, high = 2.0 * load_over_rigidity;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (shoot(middle) > 0.0 ? high : low) = middle;
  }
  return tip;
}

Vec3 tip_at_rest(const Built& built, const Settings& chosen, double until = 6.0) {
  const State state = run(built, chosen, until);
  // Where velocities hold half a kick, that of the load is among them.
  EXPECT_LT(fastest_speed(state), find_method(chosen.method)->can.half_kicked ? 1e-2 : 2e-3) << chosen.method;
  return state.position.at(state.position.size() - 1);
}

// Bisshopp and Drucker, Large Deflection of Cantilever Beams (1945), table: P L²/EI = 1 and 4 bring the tip
// down by 0.30172 L and 0.66996 L, and in by 0.05643 L and 0.32894 L.
TEST(Bending, TheElasticaIsThatOfTheBooks) {
  const auto [down, in] = elastica(1.0);
  EXPECT_NEAR(down, -0.30172, 1e-5);
  EXPECT_NEAR(in, 0.05643, 1e-5);
  const auto [far_down, far_in] = elastica(4.0);
  EXPECT_NEAR(far_down, -0.66996, 1e-5);
  EXPECT_NEAR(far_in, 0.32894, 1e-5);
}

TEST(Bending, ACantileverIsTheElasticaToSecondOrder) {
  constexpr double rigidity = 0.05, load = 0.2;  // P L²/EI = 4
  const auto [y, in] = elastica(load / rigidity);
  for (const Settings& chosen : {settings("rattle", 2400.0), settings("newton", 60.0)}) {
    std::vector<double> lengths, errors;
    for (const int links : {6, 12, 24}) {
      const Vec3 tip = tip_at_rest(clamped(cantilever(links, rigidity, load, {})), chosen);
      lengths.push_back(1.0 / (links + 0.5));
      errors.push_back(std::hypot(tip.x() - (1.0 - in), tip.y() - y));
    }
    EXPECT_GT(observed_order(lengths, errors), 1.7) << chosen.method;
    EXPECT_LT(errors.back(), 0.002) << chosen.method;
  }
}

// However stiff rods are and however coarse the steps, newton's come to rest, in the plane and out of it.
TEST(Bending, NewtonComesToRestAtAnyStiffness) {
  for (const double rigidity : {0.05, 1.0, 20.0})
    for (const double rate : {30.0, 480.0}) {
      const double load = 4.0 * rigidity;
      Description description = cantilever(20, rigidity, load, {});
      LoadSpec aside = description.loads.front();
      aside.force = {0, 0, 0.1 * load};
      aside.from = 0.6;
      aside.to = 0.8;
      aside.until = 1.0;
      aside.gone = 1.2;
      description.loads.push_back(aside);
      const Built built = clamped(description);
      const State state = run(built, settings("newton", rate), 12.0);
      const std::string label = std::to_string(rigidity) + " N m², " + std::to_string(rate) + "/s";
      EXPECT_LT(fastest_speed(state), 1e-4) << label;
      const auto [y, in] = elastica(load / rigidity);
      const Vec3 tip = state.position.at(state.position.size() - 1);
      EXPECT_NEAR(std::hypot(tip.y(), tip.z()), -y, 0.005) << label;
      EXPECT_NEAR(tip.x(), 1.0 - in, 0.005) << label;
    }
}

TEST(Bending, EveryMethodThatHasItAgrees) {
  constexpr double rigidity = 0.05, load = 0.2;
  const std::array<double, 2> exact = elastica(load / rigidity);
  const auto compare = [&](const Settings& chosen, std::optional<double> stretch) {
    const Vec3 tip = tip_at_rest(clamped(cantilever(20, rigidity, load, stretch)), chosen);
    EXPECT_NEAR(tip.y(), exact[0], 0.01) << chosen.method;
    EXPECT_NEAR(tip.x(), 1.0 - exact[1], 0.01) << chosen.method;
  };
  compare(settings("xpbd", 2400.0, 4.0), {});
  compare(settings("shake", 4800.0, 4.0), {});
  compare(settings("rattle", 2400.0), {});
  compare({"dop853", {{"tolerance", 1e-6}}}, {});
  compare(settings("spring-explicit", 20000.0), 2000.0);
  compare(settings("spring-implicit", 240.0), 2000.0);
  compare(settings("newton", 240.0), {});
  compare(settings("newton", 240.0), 2000.0);
}

TEST(Bending, MethodsWithoutItSaySo) {
  const Built built = build_valid(cantilever(6, 0.05, 0.2, {}));
  for (const std::string method : {"euler", "verlet"}) {
    const std::vector<std::string> problems = capability_problems(built.model, *find_method(method));
    ASSERT_EQ(problems.size(), 1U) << method;
    EXPECT_NE(problems.front().find("bending stiffness"), std::string::npos);
  }
  Built stiff = build_valid(cantilever(20, 500.0, 0.2, {}));
  const std::vector<std::string> problems =
      refusals(stiff.model, stiff.start, complete_settings(settings("rattle", 600.0)));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems.front().find("steps_per_second"), std::string::npos) << problems.front();
}

// What newton solves limits with knows no bends.
TEST(Bending, NewtonRefusesItBesideLinksThatOnlyPull) {
  Description description = cantilever(6, 0.05, 0.2, 2000.0);
  description.chains.front().properties.acts = LinkAction::pull;
  const Built built = build_valid(description);
  const std::vector<std::string> problems =
      refusals(built.model, built.start, complete_settings(settings("newton", 240.0)));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems.front().find("bending stiffness only where"), std::string::npos) << problems.front();
}

// Where ω·h = 2 for the stiffest vibration of a row, 4 √(k/m)/l, explicit steps end.
TEST(Bending, ExplicitStepsEndWhereTheoryHasIt) {
  Description description;
  description.gravity = Vec3::Zero();
  ChainSpec rod;
  rod.name = "rod";
  rod.to = {1, 0, 0};
  rod.links = 20;
  rod.mass = 0.21;  // 0.01 kg each
  rod.properties.stiffness = 1.0;
  rod.bending = BendingSpec{0.4, false};
  description.chains = {rod};
  Built built = build_valid(description);
  for (std::size_t i = 0; i < built.start.position.size(); ++i)
    built.start.position.add(i, Vec3(0, (i % 2 == 0 ? 1.0 : -1.0) * 1e-6, 0));
  const double highest = 4.0 * std::sqrt(0.4 / 0.01) / 0.05, limit = 0.5 * highest;  // steps per second
  const auto grows = [&](double rate) {
    taut::Run run_of(built.model, built.start, settings("spring-explicit", rate));
    for (int i = 0; i < 400 && run_of.step(); ++i) {
    }
    return !run_of.failure().empty() || std::abs(run_of.state().position.at(10).y()) > 1e-4;
  };
  EXPECT_TRUE(grows(0.93 * limit));
  EXPECT_FALSE(grows(1.02 * limit));
}

TEST(Bending, ItsEnergyIsKept) {
  Description description = cantilever(12, 0.05, 0.0, {});
  description.drag = 0.0;
  description.loads.clear();
  description.gravity = {0, -9.81, 0};
  const Built built = clamped(description);
  taut::Run run_of(built.model, built.start, settings("rattle", 4800.0));
  double most = 0.0, least = 0.0;
  for (int i = 1; i <= 60; ++i) {
    const double drift = energy(built.model, *run_of.at(i / 60.0)).total();
    most = std::max(most, drift);
    least = std::min(least, drift);
  }
  const double start = energy(built.model, built.start).total();
  EXPECT_LT(std::max(most - start, start - least), 0.01 * 0.1 * 9.81 * 0.5);
}

// Peirce, The Handle of Cloth as a Measurable Quantity (1930): a strip that hangs over an edge by l and makes
// an angle θ below the level from there to its tip has the bending length c = l (cos(θ/2)/(8 tan θ))^⅓, and
// with the weight w of an area its rigidity is D = w c³.
// Returns D as it is measured of a strip that has been given 1.2e-3 N m.
double rigidity_by_peirces_test(const Settings& chosen) {
  constexpr double overhang = 0.2, width = 0.06, area_mass = 0.2, gravity_here = 9.81;
  constexpr int rows = 22, columns = 4;
  const double length = overhang / (rows - 1.5), across = width / (columns - 1);
  Description description;
  description.drag = 6.0;
  SheetSpec sheet;
  sheet.name = "strip";
  sheet.rows = rows;
  sheet.columns = columns;
  sheet.from = {0, 0, -0.5 * length};
  sheet.to = {width, 0, -0.5 * length};
  sheet.down = {0, 0, length * (rows - 1)};
  sheet.mass = area_mass * (width + across) * length * rows;  // every mass stands for a cell
  sheet.pinned = {"top"};
  sheet.bending = SheetBendingSpec{1.2e-3 * across / length, {}, {}, 0.0, false};
  description.sheets = {sheet};
  Built built = build_valid(description);
  for (std::size_t i = columns; i < 2 * columns; ++i) built.model.masses.inverse_mass[i] = 0.0;
  const State state = run(built, chosen, 4.0);
  EXPECT_LT(fastest_speed(state), 5e-3) << chosen.method;
  const Vec3 tip = state.position.at((rows - 1) * columns);
  const double angle = std::atan2(-tip.y(), tip.z());
  EXPECT_GT(angle, 0.4) << chosen.method;  // an angle that the test is made for
  EXPECT_LT(angle, 1.0) << chosen.method;
  const double bending_length = overhang * std::cbrt(std::cos(0.5 * angle) / (8.0 * std::tan(angle)));
  return area_mass * gravity_here * std::pow(bending_length, 3.0);
}

TEST(Bending, PeircesTestMeasuresTheStiffnessOfASheet) {
  const double by_xpbd = rigidity_by_peirces_test(settings("xpbd", 2400.0, 8.0));
  EXPECT_NEAR(by_xpbd, 1.2e-3, 0.05 * 1.2e-3);
  // The formula, too, is from measurements; what is at rest is the same.
  EXPECT_NEAR(rigidity_by_peirces_test(settings("newton", 120.0)), by_xpbd, 0.005 * 1.2e-3);
}

// A strip that is stiff along its warp alone hangs down less along it than along its weft.
TEST(Bending, WarpAndWeftDiffer) {
  const auto droop = [](double warp, double weft, bool along_warp) {
    Description description;
    description.drag = 6.0;
    SheetSpec sheet;
    sheet.name = "cloth";
    sheet.rows = sheet.columns = 8;
    sheet.to = {0.2, 0, 0};
    sheet.down = {0, 0, 0.2};
    sheet.mass = 0.01;
    sheet.pinned = {along_warp ? "top" : "left"};
    sheet.bending = SheetBendingSpec{0.0, warp, weft, 0.0, false};
    description.sheets = {sheet};
    Built built = build_valid(description);
    for (std::size_t i = 0; i < 8; ++i) built.model.masses.inverse_mass[along_warp ? 8 + i : 8 * i + 1] = 0.0;
    return -run(built, settings("xpbd", 1200.0, 8.0), 3.0).position.at(63).y();
  };
  const double stiff = droop(0.02, 0.001, true), soft = droop(0.02, 0.001, false);
  EXPECT_LT(2.0 * stiff, soft);
  EXPECT_NEAR(droop(0.001, 0.02, false), stiff, 0.02 * stiff);
}

TEST(Bending, WhatIsBrokenResistsNothing) {
  Description description = cantilever(6, 0.05, 0.2, {});
  Built built = build_valid(description);
  EXPECT_EQ(whole_bends(built.model, built.start).size(), 6U);
  State state = built.start;
  state.broken_at[3] = 0.0;
  EXPECT_EQ(whole_bends(built.model, state).size(), 4U);
}

TEST(Bending, ItRestsAsItStarts) {
  Description description;
  description.gravity = Vec3::Zero();
  ChainSpec arc;
  arc.name = "arc";
  arc.to = {1, 0, 0};
  arc.length = 1.3;
  arc.links = 10;
  arc.bending = BendingSpec{0.1, true};
  description.chains = {arc};
  const Built bent = build_valid(description);
  EXPECT_LT(position_error(run(bent, settings("xpbd", 600.0), 1.0), bent.start), 1e-9);
  description.chains.front().bending->from_start = false;
  const Built straight = build_valid(description);
  EXPECT_GT(position_error(run(straight, settings("xpbd", 600.0), 1.0), straight.start), 0.1);
}

}  // namespace
}  // namespace taut::test
