#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "model/model.h"

namespace taut {

/// A sheet as rows and columns of masses, and the links between neighbours.
struct SheetLattice {
  std::size_t number = 0;  ///< of the model's sheet
  Index first_mass = 0;
  Index rows = 0, columns = 0;
  std::vector<Index> across;  ///< from each mass of a row to the next, row after row
  std::vector<Index> down;    ///< from each mass of a row to the one below it, row after row
  glm::vec2 cell{0.0F};       ///< m, mean width and height at rest

  Index mass(Index row, Index column) const { return first_mass + row * columns + column; }
  Index link_across(Index row, Index column) const { return across[row * (columns - 1) + column]; }
  Index link_down(Index row, Index column) const { return down[row * columns + column]; }
  /// Width and height at rest (m).
  glm::vec2 size() const { return cell * glm::vec2(columns - 1, rows - 1); }

  /// Masses round a cell: top left, bottom left, bottom right, top right.
  std::array<Index, 4> corners(Index row, Index column) const {
    return {mass(row, column), mass(row + 1, column), mass(row + 1, column + 1), mass(row, column + 1)};
  }
  /// Links round a cell, each from the corner of the same number to the next: left, bottom, right, top.
  std::array<Index, 4> edges(Index row, Index column) const {
    return {link_down(row, column), link_across(row + 1, column), link_down(row, column + 1),
            link_across(row, column)};
  }
};

/// Those of all sheets but meshes.
std::vector<SheetLattice> sheet_lattices(const Model& model);

}  // namespace taut
