#pragma once

#include <string>

#include "map_cells.h"

namespace taut {

/// Pixels that a legend takes at the foot of a page, and the least width of a page for it.
inline constexpr double legend_height = 178.0, legend_width = 1560.0;

/// The meaning of paints, circles and the line along the foot of a page, as a part of a multiplot.
std::string map_legend(ShadeOf what, double page_width, double page_height);

}  // namespace taut
