#pragma once

#include <glm/glm.hpp>
#include <span>

#include "geometry/sheet_lattice.h"

namespace taut {

/// How many parts each cell of a sheet is drawn in, along its rows and down its columns.
struct Fineness {
  Index across = 1, down = 1;

  bool operator==(const Fineness&) const = default;
};

/// So many that edges look smooth where cells are so large in the picture, and no more than that: triangles
/// are what drawing costs.
Fineness fineness_for(std::span<const SheetLattice> sheets, float pixels_a_metre);

/// Vertices that a sheet takes, in each direction.
inline glm::uvec2 fine_size(const SheetLattice& sheet, const Fineness& fineness) {
  return {(sheet.columns - 1) * fineness.across + 1, (sheet.rows - 1) * fineness.down + 1};
}

/// A sheet's masses (row after row) and between them places on smooth curves through them (Catmull and
/// Rom's), along rows and then down columns: fine_size() of them, row after row. Curves end where `broken`
/// (by link) cuts them.
std::vector<glm::vec3> smooth_places(const SheetLattice& sheet, const Fineness& fineness,
                                     const std::vector<bool>& broken, std::span<const glm::vec3> masses);

}  // namespace taut
