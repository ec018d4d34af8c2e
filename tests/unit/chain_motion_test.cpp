// Chains in two passes over memory against the equations of motion of everything.

#include "high_order/chain_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "high_order/equations.h"
#include "methods/simd.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

// Links from each mass to the next, but for gaps behind some.
struct ChainCase {
  std::string label;
  int masses;
  std::vector<int> pins, gaps;
  int turned_from = 0, turned_to = 0;  // masses whose links are named from the other end
};

void PrintTo(const ChainCase& c, std::ostream* out) {
  *out << c.label;
}

bool has(const std::vector<int>& all, int one) {
  return std::ranges::find(all, one) != all.end();
}

// Masses of unlike weight, with velocities that have nothing to do with the links.
Built build_chains(const ChainCase& c) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  Description description;
  for (int i = 0; i < c.masses; ++i) {
    MassSpec spec;
    spec.name = fmt::format("m{}", i);
    // Along a coil that stays near the origin, so that places are as exact for long chains.
    spec.position = Vec3(3.0 * std::cos(0.35 * i), 3.0 * std::sin(0.35 * i), 5.0 * std::sin(0.01 * i)) +
                    0.4 * Vec3(between(random), between(random), between(random));
    spec.pinned = has(c.pins, i);
    if (!spec.pinned) spec.velocity = {between(random), between(random), between(random)};
    spec.mass = std::pow(10.0, between(random));
    description.masses.push_back(spec);
  }
  for (int i = 0; i + 1 < c.masses; ++i) {
    if (has(c.gaps, i)) continue;
    std::string a = fmt::format("m{}", i), b = fmt::format("m{}", i + 1);
    if (i >= c.turned_from && i < c.turned_to) std::swap(a, b);
    description.links.push_back(LinkSpec{a, b, std::nullopt, {}});
  }
  return build_valid(description);
}

// So little drag that nothing feels it, but that the equations are no longer those of chains alone.
Model felt_by_all(Model model) {
  model.drag = 1e-300;
  return model;
}

double largest_difference(const Vectors& a, const Vectors& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a.at(i) - b.at(i)).norm());
  return largest;
}

class ChainsAlone : public ::testing::TestWithParam<ChainCase> {};

TEST_P(ChainsAlone, AreFoundAndMoveAsByTheEquationsOfEverything) {
  const Built built = build_chains(GetParam());
  const Model all = felt_by_all(built.model);
  const LinkSystem system = make_link_system(built.model, whole_rigid_links(built.model, built.start));
  ASSERT_TRUE(make_chain_motion(built.model, system, nullptr));
  ASSERT_FALSE(make_chain_motion(all, system, nullptr));
  Equations chains(built.model, built.start), general(all, built.start);
  const Vectors &x = built.start.position, &v = built.start.velocity;
  Vectors a, expected;
  ASSERT_TRUE(chains.evaluate(0.0, x, v, a));
  ASSERT_TRUE(general.evaluate(0.0, x, v, expected));
  EXPECT_LT(largest_difference(a, expected), 1e-10);
  std::vector<double> tension, expected_tension;
  chains.write_tensions(tension);
  general.write_tensions(expected_tension);
  for (std::size_t link = 0; link < tension.size(); ++link)
    EXPECT_NEAR(tension[link], expected_tension[link], 1e-10) << link;

  // As the sums of a stage, with half of everything in them.
  PhaseSums sums;
  Vectors half = x;
  for (std::size_t i = 0; i < half.size(); ++i) half.set(i, 0.5 * x.at(i) - 0.125 * v.at(i));
  sums.start(half, v, 0.125);
  sums.sums.add(x, 0.5, 0.0);
  ASSERT_TRUE(chains.evaluate(0.0, sums, a));
  EXPECT_LT(largest_difference(a, expected), 1e-9);
}

TEST_P(ChainsAlone, AreBroughtBackToTheirLengthsInTheSameWay) {
  const Built built = build_chains(GetParam());
  const Model all = felt_by_all(built.model);
  Equations chains(built.model, built.start), general(all, built.start);
  Vectors x = built.start.position, v = built.start.velocity;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!built.model.masses.pinned(i)) x.add(i, 1e-4 * v.at(i));
  Vectors expected_x = x, expected_v = v;
  ASSERT_TRUE(chains.project(x, v));
  ASSERT_TRUE(general.project(expected_x, expected_v));
  EXPECT_LT(largest_difference(x, expected_x), 1e-12);
  EXPECT_LT(largest_difference(v, expected_v), 1e-10);
  EXPECT_GT(largest_difference(x, built.start.position), 1e-6);
}

struct WidestSimdAgain {
  ~WidestSimdAgain() { force_simd(""); }
};

// What a step makes of chains: accelerations, sums, and the way back onto links.
struct Made {
  Vectors acceleration;
  Phase stage, with_others, projected;
  std::array<LargestSums, 2> largest;
};

Made make_all(const Built& built, const std::shared_ptr<Workers>& workers) {
  Equations chains(built.model, built.start, workers);
  PhaseSums sums;
  sums.start(built.start.position, built.start.velocity, 1e-3);
  sums.sums.add(built.start.velocity, 1e-4, 0.3);
  sums.sums.add(built.start.position, 1e-5, -0.7);
  std::array<VectorSums, 2> others;
  for (const double weight : {0.1, -3.0}) {
    VectorSums& other = others[weight < 0.0 ? 1 : 0];
    other.add(built.start.velocity, weight, 0.2);
    other.add(built.start.position, 0.0, weight);
  }
  Made made;
  EXPECT_TRUE(chains.evaluate(0.0, sums, made.acceleration));
  write_phase(sums, made.stage);
  made.projected = made.stage;
  EXPECT_TRUE(chains.project(made.projected.position, made.projected.velocity));
  made.largest = write_phase(sums, others, workers.get(), made.with_others);
  return made;
}

void expect_same(const Made& made, const Made& expected, const std::string& how) {
  EXPECT_EQ(made.acceleration, expected.acceleration) << how;
  EXPECT_EQ(made.stage.position, expected.stage.position) << how;
  EXPECT_EQ(made.stage.velocity, expected.stage.velocity) << how;
  EXPECT_EQ(made.projected.position, expected.projected.position) << how;
  EXPECT_EQ(made.projected.velocity, expected.projected.velocity) << how;
  EXPECT_EQ(made.with_others.position, expected.stage.position) << how;
  EXPECT_EQ(made.with_others.velocity, expected.stage.velocity) << how;
  for (std::size_t i = 0; i < made.largest.size(); ++i) {
    EXPECT_EQ(made.largest[i].position, expected.largest[i].position) << how;
    EXPECT_EQ(made.largest[i].velocity, expected.largest[i].velocity) << how;
  }
}

TEST_P(ChainsAlone, MoveTheSameWhateverTheWidthOfVectors) {
  const WidestSimdAgain again;
  const Built built = build_chains(GetParam());
  const Made expected = make_all(built, nullptr);
  for (const std::string& target : simd_targets()) {
    force_simd(target);
    expect_same(make_all(built, nullptr), expected, target);
  }
}

TEST_P(ChainsAlone, MoveTheSameOnAnyNumberOfThreads) {
  const Built built = build_chains(GetParam());
  const Made expected = make_all(built, nullptr);
  for (const int threads : {1, 2, 3})
    expect_same(make_all(built, std::make_shared<Workers>(threads)), expected,
                fmt::format("on {} threads", threads));
}

// Of a number that is none nothing is the largest.
TEST(LargestSums, AreNoNumberWhereOneIsNone) {
  Vectors some;
  for (int i = 0; i < 21; ++i) some.push_back({1.0 * i, -2.0 * i, 0.5});
  PhaseSums at;
  at.start(some, some, 0.0);
  at.sums.add(some, 0.0, 0.0);
  std::array<VectorSums, 2> others;
  others[0].add(some, 1.0, 0.5);
  others[1].add(some, 0.0, 0.0);
  Phase phase;
  EXPECT_EQ(write_phase(at, others, nullptr, phase)[0].position, 40.0);
  EXPECT_EQ(write_phase(at, others, nullptr, phase)[0].velocity, 20.0);
  EXPECT_EQ(write_phase(at, others, nullptr, phase)[1].position, 0.0);
  EXPECT_EQ(phase.position, some);
  some.y[3] = std::nan("");
  EXPECT_TRUE(std::isnan(write_phase(at, others, nullptr, phase)[0].position));
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ChainsAlone,
    ::testing::Values(ChainCase{"one_link", 2, {0}, {}}, ChainCase{"two_links", 3, {0}, {}},
                      ChainCase{"hung_by_the_last", 21, {20}, {}}, ChainCase{"in_free_fall", 21, {}, {}},
                      ChainCase{"between_pins", 30, {0, 29}, {}},
                      ChainCase{"pinned_within", 40, {0, 13, 27}, {}},
                      ChainCase{"apart", 60, {0, 30}, {9, 29, 44}},
                      ChainCase{"turned_within", 40, {0}, {}, 12, 25}, ChainCase{"a_block", 513, {0}, {}},
                      ChainCase{"a_block_and_one", 514, {0}, {}},
                      ChainCase{"two_blocks_a_half", 2020, {0}, {}}, ChainCase{"many_blocks", 5000, {0}, {}},
                      ChainCase{"many_apart", 9000, {0, 8999}, {2047, 4499, 6000}},
                      ChainCase{"long_turned", 3000, {5}, {}, 700, 1900},
                      ChainCase{"long_apart", 3500, {0, 400, 3499}, {99, 1450, 2700}}),
    [](const auto& each) { return each.param.label; });

}  // namespace
}  // namespace taut::test
