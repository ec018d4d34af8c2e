#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "high_order/second_order.h"
#include "model/limit_motion.h"

namespace taut::test {
namespace {

// Σ w_j c_j^power
double moment(const dop853::Row& row, int power) {
  double sum = 0.0;
  for (std::size_t j = 0; j < dop853::all_stages; ++j) sum += row[j] * std::pow(dop853::nodes[j], power);
  return sum;
}

// Σ b_i c_i^(k−1) = 1/k as far as order 8 goes, Σ a_ij = c_i, and in all stages but the first few also
// Σ a_ij c_j = c_i²/2 and Σ a_ij c_j² = c_i³/3.
TEST(Tableau, FulfilsItsConditions) {
  using namespace dop853;
  for (int k = 1; k <= 8; ++k) EXPECT_NEAR(moment(weights[stages], k - 1), 1.0 / k, 4e-15) << k;
  for (std::size_t stage = 1; stage < all_stages; ++stage) {
    EXPECT_NEAR(moment(weights[stage], 0), nodes[stage], 4e-14) << stage;
    if (stage > 1) {
      EXPECT_NEAR(moment(weights[stage], 1), std::pow(nodes[stage], 2) / 2.0, 4e-14) << stage;
    }
    if (stage > 4) {
      EXPECT_NEAR(moment(weights[stage], 2), std::pow(nodes[stage], 3) / 3.0, 4e-14) << stage;
    }
  }
  EXPECT_NEAR(moment(fifth_order_error, 0), 0.0, 1e-14);
  EXPECT_NEAR(moment(third_order_error, 0), 0.0, 1e-14);
}

// Σ ā_ij = c_i²/2 and, in all stages but the first few, Σ ā_ij c_j = c_i³/6; at the end Σ b̄_i c_i^(k−2) =
// 1/(k (k−1)) to order 8, and b̄_i = b_i (1 − c_i).
TEST(SecondOrder, WeightsOfPositionsFulfilTheirConditions) {
  using namespace dop853;
  for (std::size_t stage = 2; stage < all_stages; ++stage) {
    const Row row = for_positions(weights[stage]);
    EXPECT_NEAR(moment(row, 0), std::pow(nodes[stage], 2) / 2.0, 4e-14) << stage;
    if (stage > 4) {
      EXPECT_NEAR(moment(row, 1), std::pow(nodes[stage], 3) / 6.0, 4e-14) << stage;
    }
    for (std::size_t j = stage - 1; j < all_stages; ++j) EXPECT_EQ(row[j], 0.0) << stage << ' ' << j;
  }
  const Row end = for_positions(weights[stages]);
  for (int k = 2; k <= 8; ++k) EXPECT_NEAR(moment(end, k - 2), 1.0 / (k * (k - 1)), 4e-15) << k;
  for (std::size_t j = 0; j < stages; ++j) EXPECT_NEAR(end[j], weights[stages][j] * (1.0 - nodes[j]), 4e-15);
  EXPECT_NEAR(moment(for_positions(fifth_order_error), 0), 0.0, 1e-14);
  for (std::size_t i = 0; i < end_sums[0].count; ++i) {
    const std::size_t j = end_sums[0].stage[i];
    EXPECT_EQ(end_sums[2].stage[i], j);
    EXPECT_EQ(end_sums[0].position[i], end[j]);
    EXPECT_EQ(end_sums[2].velocity[i], third_order_error[j]);
  }
  for (const Row& row : interpolant) EXPECT_NEAR(moment(row, 0), 0.0, 1e-12);
}

// Angles along a motion, by differences of the angle itself.
TEST(LimitMotion, IsTheDerivativeOfTheAngle) {
  Vectors position, velocity;
  const double coordinates[6][6] = {{0.1, 0.2, 0.0, 0.3, -0.2, 0.5},  {1.1, 0.3, 0.2, -0.4, 0.7, 0.1},
                                    {0.2, 1.2, -0.1, 0.6, 0.1, -0.3}, {0.4, 0.5, 0.9, -0.2, -0.5, 0.4},
                                    {1.3, 1.0, 1.4, 0.5, 0.3, 0.8},   {0.7, 1.6, 1.1, -0.6, 0.4, -0.7}};
  for (const auto& c : coordinates) {
    position.push_back({c[0], c[1], c[2]});
    velocity.push_back({c[3], c[4], c[5]});
  }
  for (const auto& [kind, count] :
       {std::pair{LimitKind::angle, 3}, {LimitKind::hinge, 5}, {LimitKind::cone, 6}}) {
    Limit limit;
    limit.kind = kind;
    limit.count = static_cast<std::uint8_t>(count);
    limit.masses = {0, 1, 2, 3, 4, 5};
    limit.axis = Vec3(0.6, 0.0, 0.8);
    const auto angle_after = [&](double time) {
      Vectors moved = position;
      for (std::size_t i = 0; i < moved.size(); ++i) moved.add(i, time * velocity.at(i));
      return limit_angle(limit, moved);
    };
    constexpr double h = 1e-3;
    const double rate =
        (8.0 * (angle_after(h) - angle_after(-h)) - angle_after(2 * h) + angle_after(-2 * h)) / (12.0 * h);
    const double change = (16.0 * (angle_after(h) + angle_after(-h)) - angle_after(2 * h) -
                           angle_after(-2 * h) - 30.0 * angle_after(0.0)) /
                          (12.0 * h * h);
    const LimitMotion motion = limit_motion(limit, position, velocity);
    EXPECT_NEAR(motion.rate, rate, 1e-9) << count;
    EXPECT_NEAR(motion.change, change, 1e-7) << count;
  }
}

}  // namespace
}  // namespace taut::test
