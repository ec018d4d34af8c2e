#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "model/box_tree.h"

namespace taut {

/// Cells around a closed surface, of which those that it does not touch are known to be inside or outside:
/// what is far from the surface is told apart without looking for what of it is nearest.
class InsideGrid {
 public:
  enum class Cell : std::uint8_t { outside, inside, surface };

  /// `around`: the surface's box; so many cells along its longest side.
  InsideGrid(const Bounds& around, int cells);

  /// Marks what a triangle touches.
  void touch(const std::array<Vec3, 3>& corners);

  /// Tells the other cells apart, once all triangles have been: asks one place of each connected part of
  /// them.
  void fill(const std::function<bool(const Vec3&)>& is_inside);

  Cell at(const Vec3& point) const;
  /// No two places of a cell are farther from each other (m).
  double across() const { return across_; }

 private:
  Vec3 middle_of(const std::array<int, 3>& cell) const;
  std::size_t number_of(const std::array<int, 3>& cell) const;
  std::array<int, 3> cell_of(const Vec3& point) const;
  static constexpr auto unknown = static_cast<Cell>(3);  // not asked yet

  void fill_from(std::size_t first, Cell kind, std::vector<std::size_t>& open);

  Vec3 low_;
  double width_ = 1.0, across_ = 1.0;  // m
  std::array<int, 3> counts_{};
  std::vector<Cell> cells_;
};

}  // namespace taut
