// The edge of symplectic Euler on springs, measured by runs with the guard off, against ω_max·h = 2 with
// ω_max of the finite scene by power iteration and against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "measure/stability.h"
#include "measure/stability_edge.h"
#include "methods/frequency.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

constexpr double stiffness = 1e4;  // N/m
constexpr double kilogram = 1.0;

// The longest step that symplectic Euler bears for 600 of them, to half a percent.
double measured_edge(const Built& built, double expected) {
  const auto holds = [&](double h) {
    return !run_unguarded(built.model, built.start, settings("spring-explicit", 1.0 / h), 600).failed();
  };
  const auto edge = find_edge(holds, 0.5 * expected, 2.0 * expected, 1.3, 1.005);
  EXPECT_TRUE(edge.has_value());
  return edge ? edge->value() : 0.0;
}

// A chain that hangs from a pin.
Description hanging_springs(int links) {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.to = {0.0, -static_cast<double>(links), 0.0};
  chain.links = links;
  chain.mass = (links + 1) * kilogram;
  chain.pinned = {"first"};
  chain.properties.stiffness = stiffness;
  description.chains = {chain};
  return description;
}

Description hanging_net(int size, bool with_diagonals) {
  Description description;
  SheetSpec sheet;
  sheet.name = "net";
  sheet.rows = sheet.columns = size;
  sheet.to = {size - 1.0, 0.0, 0.0};
  sheet.down = {0.0, 1.0 - size, 0.0};
  sheet.mass = size * size * kilogram;
  sheet.pinned = {"top"};
  sheet.properties.stiffness = stiffness;
  if (with_diagonals) sheet.diagonals = sheet.properties;
  description.sheets = {sheet};
  return description;
}

TEST(SpringEdge, OfAnOscillatorIsTwoOverItsFrequency) {
  const Built built = build_valid(hanging_springs(1));
  const double frequency = std::sqrt(stiffness / kilogram);
  EXPECT_NEAR(highest_spring_frequency(built.model, built.start), frequency, 1e-6 * frequency);
  EXPECT_NEAR(measured_edge(built, 2.0 / frequency) * frequency, 2.0, 0.04);
}

class ChainEdge : public ::testing::TestWithParam<int> {};

// One end pinned, one free: ω_max = 2√(k/m)·cos(π/(2n + 1)) for n links, 19 % below 2√(k/m) for two.
TEST_P(ChainEdge, IsTwoOverTheHighestFrequency) {
  const int n = GetParam();
  const Built built = build_valid(hanging_springs(n));
  const double exact = 2.0 * std::sqrt(stiffness / kilogram) * std::cos(std::numbers::pi / (2 * n + 1));
  const double frequency = highest_spring_frequency(built.model, built.start);
  EXPECT_NEAR(frequency, exact, 1e-3 * exact);
  EXPECT_NEAR(measured_edge(built, 2.0 / frequency) * frequency, 2.0, 0.04);
}

INSTANTIATE_TEST_SUITE_P(Links, ChainEdge, ::testing::Values(2, 5, 20, 200));

// A large net: ω² = 4(k_s + k_d)/m; a finite one lies below. Without diagonals rows and columns vibrate like
// chains.
TEST(SpringEdge, OfASquareNetIsTwoOverItsHighestFrequency) {
  for (const bool with_diagonals : {false, true}) {
    SCOPED_TRACE(with_diagonals ? "with diagonals" : "without diagonals");
    const Built built = build_valid(hanging_net(10, with_diagonals));
    const double wide = std::sqrt((with_diagonals ? 8.0 : 4.0) * stiffness / kilogram);
    const double frequency = highest_spring_frequency(built.model, built.start);
    EXPECT_LT(frequency, wide);
    EXPECT_GT(frequency, 0.95 * wide);
    EXPECT_NEAR(measured_edge(built, 2.0 / frequency) * frequency, 2.0, 0.04);
  }
}

}  // namespace
}  // namespace taut::test
