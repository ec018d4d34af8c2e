#pragma once

#include <array>

#include "high_order/tableau.h"

namespace taut::dop853 {

// Equations of second order, ẍ = f(t, x, ẋ), need only accelerations to be kept. With k_j the slopes of the
// positions, which are the velocities of the stages, and f_j those of the velocities,
//   v_i = v + h Σ_j a_ij f_j,   x_i = x + h Σ_j a_ij v_j = x + h c_i v + h² Σ_j ā_ij f_j,   ā = a·a,
// and so for every sum over slopes: weights w of velocities go along with weights w·a of positions (Hairer,
// Nørsett and Wanner, section II.14). The method stays what it is.

/// w·a. Sums that the method's conditions make zero are so exactly, so that nobody reads what has no weight.
constexpr Row for_positions(const Row& row) {
  Row product{};
  for (std::size_t j = 0; j < all_stages; ++j) {
    double size = 0.0;
    for (std::size_t k = 0; k < all_stages; ++k) {
      const double part = row[k] * weights[k][j];
      product[j] += part;
      size += part < 0.0 ? -part : part;
    }
    const double rounding = 1e-14 * size;
    if (product[j] <= rounding && product[j] >= -rounding) product[j] = 0.0;
  }
  return product;
}

/// Weights of positions and velocities side by side, of those stages that have any.
struct StageWeights {
  std::size_t count = 0;
  std::array<std::size_t, all_stages> stage{};
  Row position{}, velocity{};
};

constexpr StageWeights side_by_side(const Row& position, const Row& velocity) {
  StageWeights all;
  for (std::size_t j = 0; j < all_stages; ++j) {
    if (position[j] == 0.0 && velocity[j] == 0.0) continue;
    all.stage[all.count] = j;
    all.position[all.count] = position[j];
    all.velocity[all.count++] = velocity[j];
  }
  return all;
}

constexpr StageWeights for_both(const Row& row) {
  return side_by_side(for_positions(row), row);
}
template <std::size_t count>
constexpr std::array<StageWeights, count> for_both(const std::array<Row, count>& rows) {
  std::array<StageWeights, count> all{};
  for (std::size_t i = 0; i < count; ++i) all[i] = for_both(rows[i]);
  return all;
}

/// The same of some rows that are worked out at once: with 0 where another of them has a weight.
template <std::size_t count>
constexpr std::array<StageWeights, count> for_both_at_once(const std::array<Row, count>& rows) {
  std::array<StageWeights, count> all{};
  for (std::size_t j = 0; j < all_stages; ++j) {
    bool any = false;
    for (const Row& row : rows) any = any || row[j] != 0.0 || for_positions(row)[j] != 0.0;
    if (!any) continue;
    for (std::size_t i = 0; i < count; ++i) {
      StageWeights& one = all[i];
      one.stage[one.count] = j;
      one.position[one.count] = for_positions(rows[i])[j];
      one.velocity[one.count++] = rows[i][j];
    }
  }
  return all;
}

/// Those of the stages (over h² and h), of the interpolant, and of a step's end with the estimates of its
/// error, of order 5 and of order 3.
inline constexpr auto stage_sums = for_both(weights);
inline constexpr auto interpolant_sums = for_both(interpolant);
inline constexpr auto end_sums =
    for_both_at_once(std::array{weights[stages], fifth_order_error, third_order_error});

}  // namespace taut::dop853
