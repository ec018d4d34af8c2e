// The angles that limits hold: values, gradients by finite differences, no force and no torque.

#include "model/limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace taut::test {
namespace {

constexpr double pi = std::numbers::pi;

Limit limit_of(LimitKind kind) {
  Limit limit;
  limit.kind = kind;
  limit.count = kind == LimitKind::angle ? 3 : kind == LimitKind::hinge ? 5 : 6;
  for (Index i = 0; i < limit.count; ++i) limit.masses[i] = i;
  limit.axis = Vec3(0.3, -0.5, 0.8).normalized();
  return limit;
}

Vectors points(std::initializer_list<Vec3> list) {
  Vectors all;
  for (const Vec3& each : list) all.push_back(each);
  return all;
}

Vectors random_points(std::mt19937& random) {
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  Vectors all;
  for (std::size_t i = 0; i < most_limit_masses; ++i) all.push_back({at(random), at(random), at(random)});
  return all;
}

// Angles may jump by a whole turn between two poses of a hinge.
double difference(double a, double b) {
  return std::remainder(a - b, 2.0 * pi);
}

// The largest error of any gradient against central differences, relative to the largest gradient.
double gradient_error(const Limit& limit, const Vectors& position, double shift) {
  const LimitAngle exact = limit_gradients(limit, position);
  double error = 0.0, size = 0.0;
  for (std::size_t slot = 0; slot < limit.count; ++slot) {
    Vec3 expected;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = shift * Vec3::Unit(axis);
      Vectors up = position, down = position;
      up.add(limit.masses[slot], step);
      down.add(limit.masses[slot], -step);
      expected[axis] = difference(limit_angle(limit, up), limit_angle(limit, down)) / (2.0 * shift);
    }
    error = std::max(error, (exact.gradient[slot] - expected).norm());
    size = std::max(size, expected.norm());
  }
  return error / size;
}

void expect_no_force_and_no_torque(const Limit& limit, const Vectors& position) {
  const LimitAngle angle = limit_gradients(limit, position);
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  double size = 0.0;
  for (std::size_t slot = 0; slot < limit.count; ++slot) {
    force += angle.gradient[slot];
    torque += position.at(limit.masses[slot]).cross(angle.gradient[slot]);
    size = std::max(size, angle.gradient[slot].norm());
  }
  EXPECT_LT(force.norm(), 1e-14 * size);
  EXPECT_LT(torque.norm(), 1e-13 * size);
}

class LimitKinds : public ::testing::TestWithParam<LimitKind> {};

TEST_P(LimitKinds, GradientsAreThoseOfFiniteDifferences) {
  const Limit limit = limit_of(GetParam());
  std::mt19937 random(3);
  for (int pose = 0; pose < 200; ++pose) {
    const Vectors position = random_points(random);
    const double angle = limit_angle(limit, position);
    // Near a straight line a shift of a millionth is no longer small beside what is left of the angle.
    if (std::abs(std::sin(angle)) < 0.05) continue;
    EXPECT_LT(gradient_error(limit, position, 1e-6), 2e-6) << "pose " << pose << ", " << angle << " rad";
  }
}

TEST_P(LimitKinds, ImpulsesSumToNoForceAndNoTorque) {
  const Limit limit = limit_of(GetParam());
  std::mt19937 random(4);
  for (int pose = 0; pose < 200; ++pose) expect_no_force_and_no_torque(limit, random_points(random));
}

TEST_P(LimitKinds, AngleIsTheSameFromBothFunctions) {
  const Limit limit = limit_of(GetParam());
  std::mt19937 random(5);
  for (int pose = 0; pose < 20; ++pose) {
    const Vectors position = random_points(random);
    EXPECT_EQ(limit_gradients(limit, position).angle, limit_angle(limit, position));
  }
}

INSTANTIATE_TEST_SUITE_P(All, LimitKinds,
                         ::testing::Values(LimitKind::angle, LimitKind::hinge, LimitKind::cone));

TEST(Limits, GradientsHoldNearZeroAndNearStraight) {
  const Limit limit = limit_of(LimitKind::angle);
  for (const double degrees : {0.01, 0.1, 1.0, 179.0, 179.9, 179.99}) {
    const double angle = degrees * pi / 180.0;
    const Vectors position =
        points({{1.3, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.0}});
    EXPECT_NEAR(limit_angle(limit, position), angle, 1e-14);
    EXPECT_LT(gradient_error(limit, position, 1e-8), 1e-6) << degrees << " degrees";
    expect_no_force_and_no_torque(limit, position);
  }
}

TEST(Limits, ALineHasGradientsOfTheRightSizeAcrossIt) {
  const Limit limit = limit_of(LimitKind::angle);
  for (const double side : {1.0, -1.0}) {
    const Vectors position = points({{2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.5 * side, 0.0, 0.0}});
    const LimitAngle angle = limit_gradients(limit, position);
    EXPECT_DOUBLE_EQ(angle.angle, side > 0.0 ? 0.0 : pi);
    EXPECT_NEAR(angle.gradient[0].norm(), 1.0 / 2.0, 1e-15);
    EXPECT_NEAR(angle.gradient[2].norm(), 1.0 / 0.5, 1e-15);
    EXPECT_EQ(angle.gradient[0].x(), 0.0);
    expect_no_force_and_no_torque(limit, position);
  }
}

// A hinge has no such trouble: straight is the middle of its circle.
TEST(Limits, HingeIsSmoothWhereItIsStraight) {
  const Limit limit = limit_of(LimitKind::hinge);
  for (const double bend : {-1e-3, -1e-9, 0.0, 1e-9, 1e-3, 1.0, -1.0, 3.1, -3.1}) {
    const Vectors position = points({{0.0, 1.0, 0.2},
                                     {0.0, 0.0, 0.1},
                                     {-std::sin(bend), -std::cos(bend), -0.3},
                                     {0.0, 0.0, 0.0},
                                     {0.0, 0.0, -0.4}});
    EXPECT_NEAR(limit_angle(limit, position), bend, 1e-14) << "right-handed about the axis";
    EXPECT_LT(gradient_error(limit, position, 1e-6), 1e-8);
  }
}

TEST(Limits, ConeGradientsHoldNearItsAxisAndOppositeIt) {
  Limit limit = limit_of(LimitKind::cone);
  limit.axis = Vec3::UnitX();
  for (const double degrees : {0.1, 1.0, 179.0, 179.9}) {
    const double angle = degrees * pi / 180.0;
    const Vectors position = points({{0.0, 0.0, 0.0},
                                     {1.0, 0.0, 0.0},
                                     {0.3, 0.7, 0.0},
                                     {0.0, 0.0, 1.0},
                                     {std::cos(angle), 0.1, 1.0 + std::sin(angle)},
                                     {std::cos(angle), -0.1, 1.0 + std::sin(angle)}});
    EXPECT_NEAR(limit_angle(limit, position), angle, 1e-13);
    EXPECT_LT(gradient_error(limit, position, 1e-8), 1e-5) << degrees << " degrees";
    expect_no_force_and_no_torque(limit, position);
  }
}

TEST(Limits, MassesNamedTwiceHaveTheirWholeGradientOnce) {
  Limit limit = limit_of(LimitKind::hinge);
  limit.masses = {0, 1, 2, 1, 3};
  std::mt19937 random(6);
  const Vectors position = random_points(random);
  const LimitAngle angle = limit_gradients(limit, position);
  EXPECT_EQ(angle.gradient[3], Vec3(0.0, 0.0, 0.0));
  expect_no_force_and_no_torque(limit, position);
  // The same hinge with two masses at one place: theirs together are the gradient of the one.
  Limit apart = limit_of(LimitKind::hinge);
  Vectors copies = position;
  copies.set(4, position.at(3));
  copies.set(3, position.at(1));
  const LimitAngle each = limit_gradients(apart, copies);
  EXPECT_LT((angle.gradient[1] - each.gradient[1] - each.gradient[3]).norm(), 1e-14);
  EXPECT_LT((angle.gradient[4] - each.gradient[4]).norm(), 1e-14);
}

TEST(Limits, OvershootIsCountedFromTheNearerEnd) {
  Limit limit = limit_of(LimitKind::hinge);
  limit.min = -2.6;
  limit.max = -0.1;
  EXPECT_NEAR(overshoot(limit, 0.3).size, 0.4, 1e-15);
  EXPECT_EQ(overshoot(limit, 0.3).sign, 1.0);
  EXPECT_NEAR(overshoot(limit, 3.1).size, 2.0 * pi - 3.1 - 2.6, 1e-14) << "round the circle";
  EXPECT_EQ(overshoot(limit, 3.1).sign, -1.0);
  EXPECT_NEAR(overshoot(limit, -0.3).size, -0.2, 1e-15);
  limit.kind = LimitKind::angle;
  limit.min = 0.5;
  limit.max = 2.0;
  EXPECT_NEAR(overshoot(limit, 3.0).size, 1.0, 1e-15);
  EXPECT_NEAR(overshoot(limit, 0.2).size, 0.3, 1e-15);
  EXPECT_LT(overshoot(limit, 1.0).size, 0.0);
}

}  // namespace
}  // namespace taut::test
