#include "geometry/fineness.h"

#include <algorithm>

#include "geometry/surface_records.h"

namespace taut {
namespace {

std::size_t vertices_of(std::span<const SheetLattice> sheets, const Fineness& fineness) {
  std::size_t sum = 0;
  for (const SheetLattice& sheet : sheets) {
    const glm::uvec2 size = fine_size(sheet, fineness);
    sum += std::size_t{size.x} * size.y;
  }
  return sum;
}

// A run of places of a grid: every `stride`th from `first` on.
struct Strand {
  std::size_t first = 0, stride = 1, count = 0;
};

// Fills in what lies between a strand's nodes, which are `parts` apart. joined(i): whether there is cloth
// from node i to the next; a curve knows nothing of what lies beyond a gap.
template <typename Joined>
void fill_strand(std::vector<glm::vec3>& places, const Strand& strand, Index parts, const Joined& joined) {
  const auto node = [&](std::size_t i) -> const glm::vec3& {
    return places[strand.first + i * parts * strand.stride];
  };
  for (std::size_t i = 0; i + 1 < strand.count; ++i) {
    const glm::vec3& from = node(i);
    const glm::vec3& to = node(i + 1);
    const bool whole = joined(i);
    const glm::vec3 before = whole && i > 0 && joined(i - 1) ? node(i - 1) : 2.0F * from - to;
    const glm::vec3 after = whole && i + 2 < strand.count && joined(i + 1) ? node(i + 2) : 2.0F * to - from;
    const glm::vec3 start = 0.5F * (to - before), end = 0.5F * (after - from);
    for (Index part = 1; part < parts; ++part) {
      const float t = static_cast<float>(part) / static_cast<float>(parts), s = 1.0F - t;
      places[strand.first + (i * parts + part) * strand.stride] = from * ((1.0F + 2.0F * t) * s * s) +
                                                                  to * (t * t * (3.0F - 2.0F * t)) +
                                                                  start * (t * s * s) - end * (t * t * s);
    }
  }
}

}  // namespace

Index parts_of(float pixels, float worth) {
  return pixels > 2.5F * worth ? 4 : pixels > worth ? 2 : 1;
}

Fineness fineness_for(std::span<const SheetLattice> sheets, float pixels_a_metre) {
  constexpr std::size_t most = 400'000;  // vertices: more can't be told apart in any picture
  glm::vec2 cell(0.0F);
  for (const SheetLattice& sheet : sheets) cell = glm::max(cell, sheet.cell * pixels_a_metre);
  // Small sheets can be finer: that costs no more than large ones do anyway.
  constexpr float worth = 18.0F, worth_if_few = 8.0F;  // pixels
  constexpr std::size_t few = 5'000;                   // vertices
  Fineness fineness{parts_of(cell.x, worth_if_few), parts_of(cell.y, worth_if_few)};
  if (vertices_of(sheets, fineness) > few) fineness = {parts_of(cell.x, worth), parts_of(cell.y, worth)};
  while (fineness != Fineness{} && vertices_of(sheets, fineness) > most)
    fineness = {std::max(fineness.across / 2, Index{1}), std::max(fineness.down / 2, Index{1})};
  return fineness;
}

std::vector<glm::vec3> smooth_places(const SheetLattice& sheet, const Fineness& fineness,
                                     const std::vector<bool>& broken, std::span<const glm::vec3> masses) {
  const Index across = fineness.across, down = fineness.down;
  if (fineness == Fineness{}) return {masses.begin(), masses.end()};
  const glm::uvec2 size = fine_size(sheet, fineness);
  const std::size_t width = size.x;
  std::vector<glm::vec3> places(width * size.y);
  for (Index row = 0; row < sheet.rows; ++row) {
    const std::size_t first = std::size_t{row} * down * width;
    for (Index column = 0; column < sheet.columns; ++column)
      places[first + column * across] = masses[std::size_t{row} * sheet.columns + column];
    fill_strand(places, {first, 1, sheet.columns}, across, [&](std::size_t column) {
      return !broken[sheet.link_across(row, static_cast<Index>(column))];
    });
  }
  for (std::size_t x = 0; x < width; ++x) {
    const auto column = static_cast<Index>(x / across);
    const bool between = x % across != 0;
    fill_strand(places, {x, width, sheet.rows}, down, [&](std::size_t row) {
      const auto at = static_cast<Index>(row);
      if (!between) return !broken[sheet.link_down(at, column)];
      const std::array<Index, 4> edges = sheet.edges(at, column);
      return std::none_of(edges.begin(), edges.end(), [&](Index link) { return broken[link]; });
    });
  }
  return places;
}

}  // namespace taut
