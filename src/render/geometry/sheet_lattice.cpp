#include "geometry/sheet_lattice.h"

#include <numeric>

namespace taut {
namespace {

float mean_length(const Model& model, const std::vector<Index>& links) {
  const double sum = std::accumulate(links.begin(), links.end(), 0.0, [&model](double length, Index link) {
    return length + model.links.length[link];
  });
  return static_cast<float>(sum / static_cast<double>(links.size()));
}

// The sheet's triangles know which links their edges are: a cell has one of its upper left and one of its
// lower right half.
SheetLattice lattice_of(const Model& model, std::size_t number) {
  const Sheet& sheet = model.sheets[number];
  SheetLattice lattice{number, sheet.first_mass, sheet.rows, sheet.columns, {}, {}, {}};
  lattice.across.resize(std::size_t{sheet.rows} * (sheet.columns - 1));
  lattice.down.resize(std::size_t{sheet.rows - 1} * sheet.columns);
  for (Index row = 0; row + 1 < sheet.rows; ++row)
    for (Index column = 0; column + 1 < sheet.columns; ++column) {
      const Index first = sheet.first_triangle + 2 * (row * (sheet.columns - 1) + column);
      const Triangle& upper = model.triangles[first];
      const Triangle& lower = model.triangles[first + 1];
      lattice.down[row * sheet.columns + column] = upper.links[0];
      lattice.across[row * (sheet.columns - 1) + column] = upper.links[2];
      lattice.across[(row + 1) * (sheet.columns - 1) + column] = lower.links[1];
      lattice.down[row * sheet.columns + column + 1] = lower.links[2];
    }
  lattice.cell = {mean_length(model, lattice.across), mean_length(model, lattice.down)};
  return lattice;
}

}  // namespace

std::vector<SheetLattice> sheet_lattices(const Model& model) {
  std::vector<SheetLattice> lattices;
  for (std::size_t i = 0; i < model.sheets.size(); ++i)
    if (!model.sheets[i].is_mesh()) lattices.push_back(lattice_of(model, i));
  return lattices;
}

}  // namespace taut
