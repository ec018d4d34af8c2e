// Rounds of a linear map that by themselves close in slowly, or not at all, come to its fixed point in as
// many rounds as it has dimensions.

#include "direct/anderson_mixing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::test {
namespace {

// s ← s + f(s) with f(s) = b − A s, A = I + a part that turns.
std::vector<double> residual(const std::vector<double>& s, double turn) {
  return {1.0 - s[0] + turn * s[1], 2.0 - s[1] - turn * s[0] + 0.3 * s[2], -1.0 - s[2] - 0.3 * s[1]};
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

double error_after(int rounds, double turn, bool mixed) {
  AndersonMixing mixing;
  mixing.begin();
  std::vector<double> s(3, 0.0);
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> change = residual(s, turn);
    if (mixed) mixing.mix(change);
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += change[i];
  }
  return largest(residual(s, turn));
}

TEST(AndersonMixing, SolvesALinearMapInAsManyRoundsAsItHasDimensions) {
  for (const double turn : {0.5, 1.5}) {
    EXPECT_LT(error_after(4, turn, true), 1e-10) << turn;
    EXPECT_GT(error_after(4, turn, false), 1e-2) << turn;
  }
}

TEST(AndersonMixing, StaysAtTheFixedPoint) {
  EXPECT_LT(error_after(40, 1.5, true), 1e-10);
}

TEST(AndersonMixing, BeginsAnewWithAnotherSize) {
  AndersonMixing mixing;
  for (const std::size_t size : {3U, 7U}) {
    mixing.begin();
    std::vector<double> change(size, 1.0);
    mixing.mix(change);
    EXPECT_EQ(change, std::vector<double>(size, 1.0));
    mixing.mix(change);
    EXPECT_TRUE(std::isfinite(largest(change)));
  }
}

}  // namespace
}  // namespace taut::test
