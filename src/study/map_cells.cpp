#include "map_cells.h"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr std::array<std::string_view, error_shades> blues{"#f0f6fc", "#d6e6f4", "#b4d3e9", "#85bcdb",
                                                           "#549fcd", "#2e7ebc", "#125ca4", "#083471"};
constexpr std::array<std::string_view, error_shades> oranges{"#fff1e3", "#fedfc0", "#fdc692", "#fda55f",
                                                             "#f78131", "#e35c0d", "#b84203", "#862a04"};

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
  if (paint < error_shades) return blues[paint];
  if (paint < 2 * error_shades) return oranges[paint - error_shades];
  return paint == paint_diverged ? "#555555" : "#bbbbbb";
}

std::vector<PaintedCells> painted_cells(const MethodMap& map, ShadeOf what) {
  std::vector<PaintedCells> painted;
  for (std::size_t column = 0; column < map.columns.size(); ++column) {
    const std::vector<RunOutcome>& cells = map.columns[column].cells;
    for (std::size_t row = 0; row < cells.size(); ++row) {
      const std::size_t paint = paint_of(cells[row], what);
      if (row > 0 && painted.back().paint == paint)
        painted.back().last_row = row;
      else
        painted.push_back({column, row, row, paint});
    }
  }
  return painted;
}

}  // namespace taut
