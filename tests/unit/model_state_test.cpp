#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <set>

#include "model/state.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

State small_state() {
  State state = build_valid(level_chain(2, 0.5)).start;
  state.time = 0.25;
  for (std::size_t i = 0; i < state.position.size(); ++i)
    state.velocity.set(i, {0.1 * static_cast<double>(i), -0.5, 0.25});
  return state;
}

std::vector<double*> hashed_numbers(State& state) {
  std::vector<double*> numbers{&state.time};
  for (Vectors* vectors : {&state.position, &state.velocity})
    for (auto* axis : {&vectors->x, &vectors->y, &vectors->z})
      for (double& value : *axis) numbers.push_back(&value);
  for (double& time : state.broken_at) numbers.push_back(&time);
  return numbers;
}

TEST(StateHash, ChangesWithEveryBit) {
  State state = small_state();
  const std::uint64_t original = state_hash(state);
  std::set<std::uint64_t> seen{original};
  std::size_t flips = 0;
  for (double* number : hashed_numbers(state))
    for (int bit = 0; bit < 64; ++bit, ++flips) {
      const double kept = *number;
      *number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(kept) ^ (std::uint64_t{1} << bit));
      seen.insert(state_hash(state));
      *number = kept;
    }
  EXPECT_EQ(flips, (1U + 18U + 2U) * 64U);
  EXPECT_EQ(seen.size(), flips + 1) << "some flips share a hash";
  EXPECT_EQ(state_hash(state), original);
}

TEST(AllFinite, FindsANumberThatIsNoneAnywhere) {
  State state = small_state();
  EXPECT_TRUE(all_finite(state)) << "links that never broke have no finite time of breaking";
  std::vector<double*> numbers = hashed_numbers(state);
  for (std::size_t i = 0; i < 1 + 18; ++i)
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
      const double kept = *numbers[i];
      *numbers[i] = bad;
      EXPECT_FALSE(all_finite(state)) << "number " << i << " = " << bad;
      *numbers[i] = kept;
    }
  *numbers[1] = std::numeric_limits<double>::max();
  *numbers[2] = std::numeric_limits<double>::max();
  EXPECT_TRUE(all_finite(state)) << "large numbers are finite";
}

// Every coordinate a cubic of its own.
State on_cubics(double time) {
  State state = small_state();
  state.time = time;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const auto k = static_cast<double>(i + 1);
    const double t = time, t2 = t * t;
    state.position.set(i, {k + 2 * t - t2 + 0.5 * k * t2 * t, -3 * t2 * t, k * t2});
    state.velocity.set(i, {2 - 2 * t + 1.5 * k * t2, -9 * t2, 2 * k * t});
  }
  return state;
}

TEST(Interpolate, IsExactForCubicMotion) {
  const State before = on_cubics(0.5), after = on_cubics(0.8);
  for (const double time : {0.5, 0.56, 0.65, 0.79, 0.8}) {
    const State exact = on_cubics(time), between = interpolate(before, after, time, Interpolation::hermite);
    EXPECT_EQ(between.time, time);
    for (std::size_t i = 0; i < exact.position.size(); ++i) {
      EXPECT_LT((between.position.at(i) - exact.position.at(i)).norm(), 1e-14) << "at " << time;
      EXPECT_LT((between.velocity.at(i) - exact.velocity.at(i)).norm(), 1e-13) << "at " << time;
    }
  }
}

TEST(Interpolate, LinearGoesAlongTheChord) {
  State before = on_cubics(0.5), after = on_cubics(0.8);
  const State between = interpolate(before, after, 0.56, Interpolation::linear);
  for (std::size_t i = 0; i < before.position.size(); ++i) {
    const Vec3 x0 = before.position.at(i), x1 = after.position.at(i);
    EXPECT_LT((between.position.at(i) - (x0 + 0.2 * (x1 - x0))).norm(), 1e-14);
    EXPECT_LT((between.velocity.at(i) - (x1 - x0) / 0.3).norm(), 1e-13);
  }
}

TEST(Interpolate, EndsAreTheGivenStates) {
  const State before = on_cubics(0.5), after = on_cubics(0.8);
  EXPECT_EQ(state_hash(interpolate(before, after, 0.5, Interpolation::hermite)), state_hash(before));
  EXPECT_EQ(state_hash(interpolate(before, after, 0.8, Interpolation::linear)), state_hash(after));
}

TEST(Interpolate, LinkIsBrokenFromItsOwnTimeOn) {
  const State before = on_cubics(0.5);
  State after = on_cubics(0.8);
  after.broken_at = {0.6, 0.8};
  EXPECT_FALSE(interpolate(before, after, 0.55, Interpolation::hermite).broken(0));
  EXPECT_TRUE(interpolate(before, after, 0.65, Interpolation::hermite).broken(0));
  EXPECT_FALSE(interpolate(before, after, 0.79, Interpolation::hermite).broken(1));
}

TEST(PlacePins, MovesOnlyDrivenPins) {
  Description description = level_chain(2, 0.5);
  description.chains[0].first_motion.path = {{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}};
  const Built built = build_valid(description);
  State state = built.start;
  place_pins(built.model, 0.5, state.position, state.velocity);
  EXPECT_NEAR(state.position.x[0], 0.5, 1e-15);
  EXPECT_NEAR(state.velocity.x[0], 30.0 / 16.0, 1e-14) << "the fastest point of a quintic from rest to rest";
  EXPECT_EQ(state.position.at(1), built.start.position.at(1));
  EXPECT_EQ(state.velocity.at(2), Vec3::Zero());
}

}  // namespace
}  // namespace taut::test
