// What friction keeps from step to step.

#include "contact/friction.h"

#include <gtest/gtest.h>

namespace taut {
namespace {

constexpr double step_size = 0.001, pull = 4.0, down = 9.81;  // s, m/s² along a level surface, m/s² onto it
constexpr double answered = 0.6;  // share of a correction that the body behind it follows

struct Slide {
  double speed;  // m/s
  Vec3 slip;     // m
};

// A contact that is pulled along a surface, of a body that follows its corrections only in part.
Slide after(int steps, double coefficient) {
  Slide slide{0.0, Vec3::Zero()};
  for (int step = 0; step < steps; ++step) {
    StickingFriction friction(slide.slip);
    Vec3 moved(step_size * slide.speed + step_size * step_size * pull, -step_size * step_size * down, 0.0);
    moved += answered * friction.hold(coefficient, step_size * step_size * down, Vec3::UnitY(), moved);
    slide = {moved.x() / step_size, friction.slip(moved)};
  }
  return slide;
}

// At rest the slip is what makes the corrections balance the pull. Forgotten, it would be a speed of
// step_size · pull · (1 − answered)/answered for ever.
TEST(StickingFriction, WhatItCanHoldComesToRestAndDoesNotCreep) {
  const Slide held = after(1000, 0.8);
  EXPECT_LT(std::abs(held.speed), 1e-15);
  EXPECT_NEAR(held.slip.x(), step_size * step_size * pull * (1.0 - answered) / answered, 1e-15);
  EXPECT_EQ(held.slip.y(), 0.0);
}

TEST(StickingFriction, BeyondThatItTakesCoulombsShareAndNoMore) {
  const Slide sliding = after(1000, 0.3);
  EXPECT_NEAR(sliding.speed, 1.0 * (pull - answered * 0.3 * down), 1e-9);
  EXPECT_NEAR(sliding.slip.norm(), 0.3 * step_size * step_size * down, 1e-15)
      << "as much as friction can hold";
}

TEST(StickingFriction, TheSumOfAllPassesIsBoundedByTheSumOfAllPushes) {
  StickingFriction friction((Vec3::Zero()));
  Vec3 moved(1e-3, 0.0, 2e-3);
  const Vec3 first = friction.hold(0.5, 4e-4, Vec3::UnitY(), moved);
  EXPECT_NEAR(first.norm(), 0.5 * 4e-4, 1e-18);
  moved += first;
  const Vec3 second = friction.hold(0.5, 1e-4, Vec3::UnitY(), moved);
  EXPECT_NEAR((first + second).norm(), 0.5 * 5e-4, 1e-18);
}

TEST(ContactSlipReader, FindsWhatWasKeptAndNothingElse) {
  const std::vector<ContactSlip> slips{{1, 4, Vec3::UnitX()}, {1, 7, Vec3::UnitY()}, {3, 0, Vec3::UnitZ()}};
  ContactSlipReader reader(slips);
  EXPECT_EQ(reader.slip(0, 9), Vec3::Zero());
  EXPECT_EQ(reader.slip(1, 4), Vec3::UnitX());
  EXPECT_EQ(reader.slip(1, 5), Vec3::Zero());
  EXPECT_EQ(reader.slip(3, 0), Vec3::UnitZ());
  EXPECT_EQ(reader.slip(3, 1), Vec3::Zero());
}

}  // namespace
}  // namespace taut
