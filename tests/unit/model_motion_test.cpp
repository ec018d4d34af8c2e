#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/motion.h"

namespace taut {
namespace {

// Dwells, turns, runs of one sign with very unlike slopes, and unequal spans.
Path winding_path() {
  return make_path({{0.0, {0.0, 1.0, 0.0}},
                    {0.5, {0.0, 1.0, 0.3}},
                    {0.6, {1.0, 3.0, 0.2}},
                    {2.6, {1.2, 2.0, 0.1}},
                    {2.7, {4.0, 2.0, -0.5}},
                    {4.0, {4.0, 5.0, 0.9}}});
}

TEST(PathMotion, GoesThroughItsKnots) {
  const Path path = winding_path();
  for (const Knot& knot : path.knots)
    EXPECT_LT((position_at(path, knot.time) - knot.position).norm(), 1e-14) << "at " << knot.time;
}

TEST(PathMotion, StaysBeforeTheFirstAndAfterTheLastKnot) {
  const Path path = winding_path();
  EXPECT_EQ(position_at(path, -3.0), path.knots.front().position);
  EXPECT_EQ(position_at(path, 9.0), path.knots.back().position);
  EXPECT_EQ(velocity_at(path, -3.0), Vec3::Zero());
  EXPECT_EQ(velocity_at(path, 9.0), Vec3::Zero());
}

TEST(PathMotion, OfOneKnotIsAPlace) {
  const Path path = make_path({{1.0, {3.0, 2.0, 1.0}}});
  for (const double time : {0.0, 1.0, 2.0}) {
    EXPECT_EQ(position_at(path, time), Vec3(3.0, 2.0, 1.0));
    EXPECT_EQ(velocity_at(path, time), Vec3::Zero());
  }
}

// Central differences, away from knots.
TEST(PathMotion, VelocityAndAccelerationAreExactDerivatives) {
  const Path path = winding_path();
  constexpr double h = 1e-5;
  for (double time = -0.25; time < 4.5; time += 0.0171) {
    const Vec3 slope = (position_at(path, time + h) - position_at(path, time - h)) / (2.0 * h);
    const Vec3 bend = (velocity_at(path, time + h) - velocity_at(path, time - h)) / (2.0 * h);
    EXPECT_LT((velocity_at(path, time) - slope).norm(), 2e-5) << "at " << time;
    EXPECT_LT((acceleration_at(path, time) - bend).norm(), 2e-3) << "at " << time;
  }
}

TEST(PathMotion, IsTwiceContinuouslyDifferentiable) {
  const Path path = winding_path();
  for (const Knot& knot : path.knots) {
    const double before = knot.time - 1e-9, after = knot.time + 1e-9;
    EXPECT_LT((position_at(path, after) - position_at(path, before)).norm(), 1e-6) << "at " << knot.time;
    EXPECT_LT((velocity_at(path, after) - velocity_at(path, before)).norm(), 1e-6) << "at " << knot.time;
    EXPECT_LT((acceleration_at(path, after) - acceleration_at(path, before)).norm(), 1e-3)
        << "at " << knot.time;
  }
  EXPECT_GT(acceleration_at(path, 0.52).norm(), 10.0) << "between knots it is not small";
}

// No coordinate leaves the interval between its two knots, nor turns within it, for any spacing of knots.
TEST(PathMotion, NeverOvershootsItsKnots) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-2.5, 1.0), rise(-1.0, 1.0);
  for (int round = 0; round < 400; ++round) {
    std::vector<Knot> knots{{0.0, Vec3::Zero()}};
    for (int i = 0; i < 6; ++i) {
      const double span = std::pow(10.0, exponent(random));
      knots.push_back({knots.back().time + span,
                       knots.back().position + Vec3(rise(random), std::abs(rise(random)), 0.3 * span)});
    }
    const Path path = make_path(knots);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      Vec3 last = knots[i].position;
      const Vec3 way = knots[i + 1].position - knots[i].position;
      for (int part = 1; part <= 50; ++part) {
        const Vec3 now =
            position_at(path, knots[i].time + (knots[i + 1].time - knots[i].time) * (part / 50.0));
        for (int axis = 0; axis < 3; ++axis)
          ASSERT_GE((now[axis] - last[axis]) * (way[axis] > 0.0 ? 1.0 : -1.0), -1e-12)
              << "round " << round << ", segment " << i << ", axis " << axis << ", part " << part;
        last = now;
      }
    }
  }
}

// On a straight run of equal slopes the pin keeps its speed through the knot.
TEST(PathMotion, KeepsItsSpeedThroughKnotsInARow) {
  const Path path = make_path({{0.0, {0, 0, 0}}, {1.0, {2, 0, 0}}, {2.0, {4, 0, 0}}, {5.0, {10, 0, 0}}});
  EXPECT_NEAR(velocity_at(path, 1.0).x(), 2.0, 1e-14);
  EXPECT_NEAR(velocity_at(path, 2.0).x(), 2.0, 1e-14);
  EXPECT_NEAR(position_at(path, 1.3).x(), 2.6, 1e-14);
}

TEST(SinusoidMotion, IsWhatItsFormulaSays) {
  const Sinusoid motion{{1.0, 2.0, 3.0}, {0.5, -0.25, 0.0}, 4.0, 0.3};
  for (const double time : {0.0, 0.7, 2.0}) {
    const double angle = 4.0 * time + 0.3;
    const Vec3 exact(1.0 + 0.5 * std::sin(angle), 2.0 - 0.25 * std::sin(angle), 3.0);
    EXPECT_LT((position_at(motion, time) - exact).norm(), 1e-15);
    EXPECT_LT((velocity_at(motion, time) - Vec3(2.0, -1.0, 0.0) * std::cos(angle)).norm(), 1e-15);
    EXPECT_LT((acceleration_at(motion, time) - Vec3(-8.0, 4.0, 0.0) * std::sin(angle)).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace taut
