#include "model/inside_grid.h"

#include <algorithm>
#include <cmath>

#include "model/face_pairs.h"

namespace taut {
namespace {

constexpr double margin = 1e-9;  // of a cell, by which what it touches is taken to be larger

}  // namespace

InsideGrid::InsideGrid(const Bounds& around, int cells) {
  const Vec3 size = around.high - around.low;
  width_ = size.maxCoeff() / cells;
  across_ = width_ * std::sqrt(3.0);
  low_ = around.low - Vec3::Constant(0.5 * width_);
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int along = static_cast<int>(std::floor(size[axis] / width_)) + 2;
    counts_.at(static_cast<std::size_t>(axis)) = along;
    count *= static_cast<std::size_t>(along);
  }
  cells_.assign(count, Cell::outside);
}

Vec3 InsideGrid::middle_of(const std::array<int, 3>& cell) const {
  return low_ + width_ * Vec3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5);
}

std::size_t InsideGrid::number_of(const std::array<int, 3>& cell) const {
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(counts_[1]) +
          static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(counts_[0]) +
         static_cast<std::size_t>(cell[0]);
}

// Of a place within the grid's box.
std::array<int, 3> InsideGrid::cell_of(const Vec3& point) const {
  std::array<int, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int at = static_cast<int>(axis);
    cell[axis] =
        std::clamp(static_cast<int>(std::floor((point[at] - low_[at]) / width_)), 0, counts_[axis] - 1);
  }
  return cell;
}

InsideGrid::Cell InsideGrid::at(const Vec3& point) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int along = static_cast<int>(axis);
    const double from_low = point[along] - low_[along];
    if (!(from_low >= 0.0 && from_low <= width_ * counts_[axis])) return Cell::outside;
  }
  return cells_[number_of(cell_of(point))];
}

// A triangle that touches a cell comes as near to its middle as half the cell is across.
void InsideGrid::touch(const std::array<Vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 slack = Vec3::Constant(margin * width_);
  const std::array<int, 3> low = cell_of(a.cwiseMin(b).cwiseMin(c) - slack),
                           high = cell_of(a.cwiseMax(b).cwiseMax(c) + slack);
  std::array<int, 3> cell = low;
  for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
    for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
      for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
        if (nearest_gap(false, {middle_of(cell), a, b, c}).distance <= (0.5 + margin) * across_)
          cells_[number_of(cell)] = Cell::surface;
}

void InsideGrid::fill_from(std::size_t first, Cell kind, std::vector<std::size_t>& open) {
  const std::array<std::size_t, 3> strides{
      1, static_cast<std::size_t>(counts_[0]),
      static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1])};
  open.assign(1, first);
  while (!open.empty()) {
    const std::size_t number = open.back();
    open.pop_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t along = number / strides[axis] % static_cast<std::size_t>(counts_[axis]);
      const auto take = [&](std::size_t next) {
        if (cells_[next] != unknown) return;
        cells_[next] = kind;
        open.push_back(next);
      };
      if (along > 0) take(number - strides[axis]);
      if (along + 1 < static_cast<std::size_t>(counts_[axis])) take(number + strides[axis]);
    }
  }
}

void InsideGrid::fill(const std::function<bool(const Vec3&)>& is_inside) {
  for (Cell& cell : cells_)
    if (cell != Cell::surface) cell = unknown;
  std::vector<std::size_t> open;
  std::array<int, 3> cell{};
  for (cell[2] = 0; cell[2] < counts_[2]; ++cell[2])
    for (cell[1] = 0; cell[1] < counts_[1]; ++cell[1])
      for (cell[0] = 0; cell[0] < counts_[0]; ++cell[0]) {
        const std::size_t number = number_of(cell);
        if (cells_[number] != unknown) continue;
        cells_[number] = is_inside(middle_of(cell)) ? Cell::inside : Cell::outside;
        fill_from(number, cells_[number], open);
      }
}

}  // namespace taut
