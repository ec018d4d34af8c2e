#include "model/near_balls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace taut {
namespace {

constexpr double near_gap = 0.02;  // m
constexpr std::size_t no_end = 1'000'000;

struct Heap {
  std::vector<BodyBall> balls;
  std::vector<Vec3> places;
};

// Balls in a box with an edge of 2 m, several to a body, of radii from a millimetre to half a metre.
Heap heap_of(std::uint32_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.0, 1.0), magnitude(-3.0, -0.3);
  Heap heap;
  for (std::uint32_t i = 0; i < count; ++i) {
    heap.balls.push_back({std::pow(10.0, magnitude(random)), i / 5});
    heap.places.emplace_back(place(random), place(random), place(random));
  }
  return heap;
}

NearBalls::Pairs pairs_one_by_one(const Heap& heap) {
  NearBalls::Pairs pairs;
  for (std::uint32_t a = 0; a < heap.balls.size(); ++a)
    for (std::uint32_t b = a + 1; b < heap.balls.size(); ++b)
      if (heap.balls[a].body != heap.balls[b].body &&
          (heap.places[a] - heap.places[b]).norm() <= heap.balls[a].radius + heap.balls[b].radius + near_gap)
        pairs.emplace_back(a, b);
  return pairs;
}

TEST(NearBalls, FindsThePairsThatLookingAtAllOfThemFinds) {
  const Heap heap = heap_of(400);
  NearBalls::Pairs found;
  NearBalls(heap.balls, near_gap).find(heap.places, no_end, found);
  EXPECT_EQ(found, pairs_one_by_one(heap));
  EXPECT_GT(found.size(), 500U) << "a heap, not a gas";
}

TEST(NearBalls, BallsOfOneBodyAreNoPairs) {
  Heap heap = heap_of(100);
  for (BodyBall& ball : heap.balls) ball.body = 3;
  NearBalls::Pairs found;
  NearBalls(heap.balls, near_gap).find(heap.places, no_end, found);
  EXPECT_TRUE(found.empty());
}

TEST(NearBalls, StopsLookingOnceThereAreTooMany) {
  Heap heap;
  for (Index body = 0; body < 3000; ++body) heap.balls.push_back({0.1, body});
  heap.places.assign(heap.balls.size(), Vec3::Zero());
  NearBalls::Pairs found;
  NearBalls(heap.balls, near_gap).find(heap.places, 10'000, found);
  EXPECT_GT(found.size(), 10'000U);
  EXPECT_LT(found.size(), 20'000U) << "of 4.5 million";
}

TEST(NearBalls, WhatIsNowhereMeetsNothing) {
  Heap heap = heap_of(20);
  heap.places[3].x() = std::nan("");
  heap.places[4].y() = HUGE_VAL;
  NearBalls::Pairs found;
  NearBalls(heap.balls, near_gap).find(heap.places, no_end, found);
  EXPECT_EQ(found, pairs_one_by_one(heap));
}

}  // namespace
}  // namespace taut
