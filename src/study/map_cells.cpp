#include "map_cells.h"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

// The lightest of the dark ones is a good deal darker than the darkest of the light ones.
constexpr std::array<std::string_view, error_shades> light_blues{"#f0f9fc", "#dcf1fa", "#c8e8f8", "#b5dff7",
                                                                 "#a3d5f6", "#93cbf6", "#85c0f6", "#79b5f5"};
constexpr std::array<std::string_view, error_shades> dark_reds{"#e46600", "#d45603", "#c2480a", "#af3b0e",
                                                               "#9d2e0f", "#8a220e", "#78160d", "#650908"};

std::size_t shade_in(const RunOutcome& cell, ShadeOf what) {
  const bool by_error = what == ShadeOf::error && std::isfinite(cell.error);
  const double error = by_error ? cell.error : cell.strain;
  if (!std::isfinite(error)) return error_shades - 1;
  const double share =
      std::log(std::max(error, least_error) / least_error) / std::log(most_error / least_error);
  return std::min(static_cast<std::size_t>(share * static_cast<double>(error_shades)), error_shades - 1);
}

std::size_t paint_of(const RunOutcome& cell, ShadeOf what) {
  switch (cell.fate) {
    case Fate::held:
      return shade_in(cell, what);
    case Fate::drifted:
      return error_shades + shade_in(cell, what);
    case Fate::diverged:
      return paint_diverged;
    case Fate::refused:
      break;
  }
  return paint_refused;
}

}  // namespace

std::string_view map_paint(std::size_t paint) {
  if (paint < error_shades) return light_blues[paint];
  if (paint < 2 * error_shades) return dark_reds[paint - error_shades];
  return "#ffffff";
}

std::vector<std::size_t> map_paints(const MapGrid& grid, const MethodMap& map) {
  const ShadeOf what = shade_of(grid);
  std::vector<std::size_t> paints(grid.columns.size() * grid.rows.size(), paint_missing);
  for (const MapColumn& column : map.columns) {
    const auto at =
        static_cast<std::size_t>(std::ranges::find(grid.columns, column.value) - grid.columns.begin());
    if (at == grid.columns.size()) continue;
    for (std::size_t row = 0; row < column.cells.size(); ++row)
      paints[row * grid.columns.size() + at] = paint_of(column.cells[row], what);
  }
  return paints;
}

std::vector<CellBox> boxes_of(const std::vector<std::size_t>& paints, std::size_t columns,
                              std::size_t paint) {
  std::vector<CellBox> boxes;
  for (std::size_t column = 0; column < columns; ++column)
    for (std::size_t row = 0; row * columns < paints.size(); ++row) {
      if (paints[row * columns + column] != paint) continue;
      const bool on = row > 0 && paints[(row - 1) * columns + column] == paint;
      if (on)
        boxes.back().last_row = row;
      else
        boxes.push_back({column, row, row});
    }
  return boxes;
}

}  // namespace taut
