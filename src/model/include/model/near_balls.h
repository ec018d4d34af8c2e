#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// Pairs that are solved in every step, more than which no machine steps through in any time.
inline constexpr std::size_t most_near_pairs = 20'000'000;

/// A ball of a body, which other balls of the same body don't count for.
struct BodyBall {
  double radius = 0.0;  ///< m
  Index body = 0;
};

/// Finds balls of different bodies that are near each other, on a hashed grid (Teschner et al., Optimized
/// Spatial Hashing for Collision Detection, 2003) with cells of several sizes where balls are of several, so
/// that a large one doesn't make small ones share cells.
class NearBalls {
 public:
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  /// Balls are near when the gap between them is at most `margin` (m), which is above 0.
  NearBalls(std::vector<BodyBall> balls, double margin);

  /// The pairs of balls that are near each other with centres at these places, by their indices, sorted.
  /// Stops looking once there are more than `most`, and leaves those in no order.
  void find(const std::vector<Vec3>& centres, std::size_t most, Pairs& pairs);

 private:
  using Cell = std::array<std::int64_t, 3>;

  // Cells of one size, for balls that reach no further and further than half of it.
  struct Level {
    double cell_size;  // m
    std::uint32_t number;
  };

  // Tables of the grid, kept to save their memory.
  struct Grid {
    std::vector<Cell> cells;            // of each ball, in those of its level
    std::vector<std::uint32_t> begins;  // of each bucket
    std::vector<std::uint32_t> balls;   // bucket after bucket, in each of them rising
    std::vector<std::uint32_t> beyond;  // of each of these, where in its bucket the next body begins
  };

  void sort_into_levels();
  static Cell cell_at(const Vec3& place, const Level& level);
  std::size_t bucket_of(const Cell& cell, const Level& level) const;
  const Level& level_of(std::uint32_t ball) const { return levels_[level_of_[ball]]; }
  void fill_grid(const std::vector<Vec3>& centres);
  void find_pairs(std::uint32_t ball, const std::vector<Vec3>& centres, Pairs& pairs) const;
  void find_pairs_in(const Cell& cell, const Level& level, std::uint32_t ball,
                     const std::vector<Vec3>& centres, Pairs& pairs) const;

  std::vector<BodyBall> balls_;
  double margin_;
  std::vector<Level> levels_;            // of the grid, the largest cells first
  std::vector<std::uint32_t> level_of_;  // each ball
  Grid grid_;
};

}  // namespace taut
