#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "study/stability_map.h"

namespace taut {

/// A part of a map that is painted in one go: neighbouring cells of a column with the same paint.
struct PaintedCells {
  std::size_t column;
  std::size_t first_row, last_row;
  std::size_t paint;  ///< see map_paints()
};

/// How many shades tell errors of runs that held, and as many those of runs that drifted.
inline constexpr std::size_t error_shades = 8;

/// The error at the lower end of the first shade and at the upper end of the last one, over the total link
/// length.
inline constexpr double least_error = 1e-7, most_error = 1e1;

/// Paints: error_shades of blue for runs that held, as many of orange for those that drifted, then the two
/// below. Blue and orange differ for every kind of colour vision, and each gets darker with the error.
std::string_view map_paint(std::size_t paint);
inline constexpr std::size_t paint_diverged = 2 * error_shades;
inline constexpr std::size_t paint_refused = paint_diverged + 1;

/// What shades stand for: the position error over the total link length, the largest strain in maps over
/// passes.
enum class ShadeOf { error, strain };
inline ShadeOf shade_of(const MapGrid& grid) {
  return grid.axes->rows == MapRows::step ? ShadeOf::error : ShadeOf::strain;
}

/// The cells of a map, neighbours in a column joined. Where a run has no reference its largest strain stands
/// in for the error.
std::vector<PaintedCells> painted_cells(const MethodMap& map, ShadeOf what);

}  // namespace taut
