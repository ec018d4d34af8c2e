#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "study/stability_map.h"

namespace taut {

/// How many shades tell errors of runs that held, and as many those of runs that drifted.
inline constexpr std::size_t error_shades = 8;

/// The error at the lower end of the first shade and at the upper end of the last one, over the total link
/// length.
inline constexpr double least_error = 1e-7, most_error = 1e1;

/// Paints: error_shades of light blue for runs that held, as many of dark red for those that drifted, each
/// darker with the error, then white for those below, of which the first two are hatched. Where all is grey
/// light and dark still tell held from drifted, and hatches the rest.
std::string_view map_paint(std::size_t paint);
inline constexpr std::size_t paint_diverged = 2 * error_shades;
inline constexpr std::size_t paint_refused = paint_diverged + 1;
inline constexpr std::size_t paint_missing = paint_refused + 1;  ///< not run

/// What shades stand for: the position error over the total link length, the largest strain in maps over
/// passes.
enum class ShadeOf { error, strain };
inline ShadeOf shade_of(const MapGrid& grid) {
  return grid.axes->rows == MapRows::step ? ShadeOf::error : ShadeOf::strain;
}

/// The paint of every cell of a map, row by row from the foot. Where a run has no reference its largest
/// strain stands in for the error.
std::vector<std::size_t> map_paints(const MapGrid& grid, const MethodMap& map);

/// Cells of a column that lie one above the other.
struct CellBox {
  std::size_t column = 0, first_row = 0, last_row = 0;
};

/// All cells of one paint, neighbours in a column joined.
std::vector<CellBox> boxes_of(const std::vector<std::size_t>& paints, std::size_t columns, std::size_t paint);

}  // namespace taut
