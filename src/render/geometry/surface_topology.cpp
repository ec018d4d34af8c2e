#include "geometry/surface_topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/tears.h"
#include "geometry/view_matrices.h"
#include "render/appearance.h"

namespace taut {
namespace {

constexpr float no_hem_near = 100.0F;  // hem widths

/// Length in sheet cells of a checker square.
float checker_square(const SheetLattice& sheet) {
  return std::max(1.0F, std::round(static_cast<float>(std::min(sheet.rows, sheet.columns)) / 14.0F));
}

/// Threads of a weave where the look says nothing of them: about eighty across the sheet are fine, and still
/// seen from afar.
float thread_pitch(const SheetLattice& sheet, const Look& look) {
  if (look.thread_pitch > 0.0) return static_cast<float>(look.thread_pitch);
  const glm::vec2 size = sheet.size();
  return std::min(size.x, size.y) / 80.0F;
}

glm::vec2 units_per_cell(const SheetLattice& sheet, const Look& look) {
  if (look.pattern == Pattern::checker) return glm::vec2(1.0F / checker_square(sheet));
  return sheet.cell / std::max(thread_pitch(sheet, look), 1e-9F);
}

float hem_width(const SheetLattice& sheet, const Look& look) {
  const glm::vec2 size = sheet.size();
  return look.hem_width ? static_cast<float>(*look.hem_width) : 0.018F * std::min(size.x, size.y);
}

// Triangles of meshes below all sheets, about as wide as high.
void spread_meshes(SpreadSheets& spread, const MeshCloth& meshes) {
  if (meshes.empty()) return;
  MeshBlocks& blocks = spread.blocks;
  blocks.count = static_cast<Index>(meshes.triangles.size());
  blocks.side = meshes.parts + 3;
  blocks.first_row = static_cast<Index>(spread.places.height);
  const auto square = static_cast<Index>(std::ceil(std::sqrt(static_cast<double>(blocks.count))));
  blocks.a_row = std::max(square, static_cast<Index>(spread.places.width) / blocks.side);
  const Index rows = (blocks.count + blocks.a_row - 1) / blocks.a_row;
  spread.places.width = std::max(spread.places.width, static_cast<int>(blocks.a_row * blocks.side));
  spread.places.height += static_cast<int>(rows * blocks.side);
  spread.cell_size = glm::max(spread.cell_size, glm::vec2(meshes.part_length));
}

SpreadSheets spread_sheets(const Cloth& cloth) {
  SpreadSheets spread;
  for (const SheetLattice& sheet : cloth.sheets) {
    const glm::uvec2 size = fine_size(sheet, cloth.fineness);
    spread.sheets.push_back(size);
    spread.places.width = std::max(spread.places.width, static_cast<int>(size.x));
    spread.places.height += static_cast<int>(size.y);
    spread.cell_size =
        glm::max(spread.cell_size, sheet.cell / glm::vec2(cloth.fineness.across, cloth.fineness.down));
  }
  spread_meshes(spread, cloth.meshes);
  return spread;
}

struct Growing {
  std::vector<Index> indices, mass_triangles;
  std::vector<SurfacePlace> places;
};

void add_places(Growing& surface, const Cloth& cloth, std::size_t number, float first_light_row) {
  const SheetLattice& sheet = cloth.sheets[number];
  const glm::uvec2 size = fine_size(sheet, cloth.fineness);
  for (glm::uint y = 0; y < size.y; ++y)
    for (glm::uint x = 0; x < size.x; ++x) {
      const glm::vec2 at = glm::vec2(x, y) / glm::vec2(cloth.fineness.across, cloth.fineness.down);
      surface.places.push_back(place_on_sheet(cloth, number, at, glm::vec2(x, first_light_row + float(y))));
    }
}

// A cell's triangles share its rising diagonal.
void add_cell(std::vector<Index>& indices, const std::array<Index, 4>& corners) {
  const auto [top_left, bottom_left, bottom_right, top_right] = corners;
  indices.insert(indices.end(), {top_left, bottom_left, top_right, top_right, bottom_left, bottom_right});
}

bool is_torn(const std::array<Index, 4>& edges, const std::vector<bool>& broken) {
  return std::any_of(edges.begin(), edges.end(), [&broken](Index link) { return broken[link]; });
}

void add_whole_cell(Growing& surface, const FineCell& cell, const std::array<Index, 4>& masses) {
  add_cell(surface.mass_triangles, masses);
  for (Index down = 0; down < cell.fineness.down; ++down)
    for (Index across = 0; across < cell.fineness.across; ++across)
      add_cell(surface.indices, {cell.vertex(across, down), cell.vertex(across, down + 1),
                                 cell.vertex(across + 1, down + 1), cell.vertex(across + 1, down)});
}

// How far things hide light from cloth, in cells: as far as a fold is deep.
constexpr float cells_nearby = 4.0F;

float largest_cell(const Cloth& cloth) {
  float cell = cloth.meshes.part_length * static_cast<float>(cloth.meshes.parts);
  for (const SheetLattice& sheet : cloth.sheets)
    cell = std::max(cell, std::sqrt(sheet.cell.x * sheet.cell.y));
  return cell;
}

// In sheets the first of each four, in meshes that of a neighbour or a mass itself; what tears changes none.
std::vector<Index> groups_of(const Cloth& cloth) {
  std::vector<Index> groups(cloth.at_start.size());
  std::iota(groups.begin(), groups.end(), Index{0});
  for (const SheetLattice& sheet : cloth.sheets)
    for (Index row = 0; row < sheet.rows; ++row)
      for (Index column = 0; column < sheet.columns; ++column)
        groups[sheet.mass(row, column)] = sheet.mass(row / 2 * 2, column / 2 * 2);
  std::vector<bool> taken(groups.size(), false);
  for (const MeshTriangle& triangle : cloth.meshes.triangles) {
    const Index first = triangle.masses[0];
    if (groups[first] != first) continue;
    taken[first] = true;
    for (const Index mass : triangle.masses) {
      if (!taken[mass]) groups[mass] = first;
      taken[mass] = true;
    }
  }
  return groups;
}

std::vector<bool> broken_links(const State& state) {
  std::vector<bool> broken(state.broken_at.size());
  for (std::size_t link = 0; link < broken.size(); ++link) broken[link] = state.broken(link);
  return broken;
}

}  // namespace

SurfacePlace place_on_sheet(const Cloth& cloth, std::size_t number, const glm::vec2& at,
                            const glm::vec2& light) {
  const SheetLattice& sheet = cloth.sheets[number];
  SurfacePlace place{cloth.units[number] * at, glm::vec3(no_hem_near, no_hem_near, 1.0F), light};
  if (cloth.hems[number] > 0.0F) {
    const glm::vec2 inwards = glm::min(at, glm::vec2(sheet.columns - 1, sheet.rows - 1) - at);
    place.edges = glm::vec3(inwards * sheet.cell / cloth.hems[number], 1.0F);
  }
  return place;
}

Cloth cloth_of(const Model& model, const State& start, const Look& look, float pixels_a_metre) {
  Cloth cloth;
  cloth.sheets = sheet_lattices(model);
  const std::vector<bool> drawn = appearance(model, look).sheets;
  cloth.meshes = mesh_cloth(model, start, look, drawn, pixels_a_metre);
  std::erase_if(cloth.sheets, [&](const SheetLattice& sheet) { return !drawn[sheet.number]; });
  cloth.fineness = fineness_for(cloth.sheets, pixels_a_metre);
  for (const SheetLattice& sheet : cloth.sheets) {
    cloth.units.push_back(units_per_cell(sheet, look));
    cloth.hems.push_back(hem_width(sheet, look));
    if (!has_own_cloth_colours(look)) continue;
    const ClothColours colours = cloth_colours(look, model, sheet.number);
    cloth.tints.push_back({opaque(colours.front), opaque(colours.back)});
  }
  for (std::size_t mass = 0; mass < start.position.size(); ++mass)
    cloth.at_start.push_back(to_glm(start.position.at(mass)));
  cloth.spread = std::make_shared<const SpreadSheets>(spread_sheets(cloth));
  cloth.groups = groups_of(cloth);
  cloth.nearby = cells_nearby * largest_cell(cloth);
  return cloth;
}

std::shared_ptr<const SurfaceTopology> surface_topology(
    const Cloth& cloth, const State& state, const std::shared_ptr<const SurfaceTopology>& before) {
  auto topology = std::make_shared<SurfaceTopology>();
  topology->broken = broken_links(state);
  if (before && before->broken == topology->broken) return before;

  Growing surface;
  std::vector<TornCell> torn;
  Index first_vertex = 0;
  float light_row = 0.0F;
  for (std::size_t number = 0; number < cloth.sheets.size(); ++number) {
    const SheetLattice& sheet = cloth.sheets[number];
    const glm::uvec2 size = fine_size(sheet, cloth.fineness);
    add_places(surface, cloth, number, light_row);
    for (Index row = 0; row + 1 < sheet.rows; ++row)
      for (Index column = 0; column + 1 < sheet.columns; ++column) {
        const FineCell cell{
            cloth.fineness, size.x,
            first_vertex + row * cloth.fineness.down * size.x + column * cloth.fineness.across};
        if (is_torn(sheet.edges(row, column), topology->broken))
          torn.push_back({number, row, column, cell});
        else
          add_whole_cell(surface, cell, sheet.corners(row, column));
      }
    first_vertex += size.x * size.y;
    light_row += static_cast<float>(size.y);
  }
  cut(*topology, cloth, torn, surface.places, surface.indices);
  topology->sheet_indices = surface.indices.size();
  topology->sheet_vertices = surface.places.size();
  if (!cloth.meshes.empty()) {
    topology->meshes =
        mesh_topology(cloth.meshes, cloth.spread->blocks, topology->broken, surface.places, surface.indices);
    for (const Index whole : topology->meshes.whole)
      for (const Index mass : cloth.meshes.triangles[whole].masses) surface.mass_triangles.push_back(mass);
  }
  topology->mass_triangles = std::move(surface.mass_triangles);
  topology->indices = std::make_shared<const std::vector<Index>>(std::move(surface.indices));
  topology->places = std::make_shared<const std::vector<SurfacePlace>>(std::move(surface.places));
  return topology;
}

float jitter(Index seed, Index salt) {
  // Two rounds of a multiply and shift mix every bit of both into the rest.
  std::uint32_t bits = seed * 0x9E3779B9U + salt * 0x85EBCA6BU + 0x27D4EB2FU;
  bits = (bits ^ (bits >> 15U)) * 0x2C1B3C6DU;
  bits = (bits ^ (bits >> 12U)) * 0x297A2D39U;
  bits ^= bits >> 15U;
  return static_cast<float>(bits >> 8U) / 8388608.0F - 1.0F;
}

}  // namespace taut
