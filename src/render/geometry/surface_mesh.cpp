#include "geometry/surface_mesh.h"

#include <algorithm>
#include <cmath>

#include "geometry/view_matrices.h"

namespace taut {
namespace {

/// Length in sheet cells of a checker square.
float checker_square(const Sheet& sheet) {
  return std::max(1.0F, std::round(static_cast<float>(std::min(sheet.rows, sheet.columns)) / 14.0F));
}

/// A weave of about eighty threads across the sheet is fine, and still seen from afar.
float threads_per_cell(const Sheet& sheet) {
  return std::clamp(std::round(80.0F / static_cast<float>(std::min(sheet.rows, sheet.columns))), 1.0F, 6.0F);
}

float units_per_cell(const Sheet& sheet, Pattern pattern) {
  return pattern == Pattern::checker ? 1.0F / checker_square(sheet) : threads_per_cell(sheet);
}

/// Mean width and height (m) of a sheet's cells.
glm::vec2 mean_cell(const Sheet& sheet, const State& state) {
  glm::vec2 sum(0.0F);
  for (Index row = 0; row < sheet.rows; ++row)
    for (Index column = 0; column < sheet.columns; ++column) {
      const Index mass = sheet.first_mass + row * sheet.columns + column;
      const auto distance = [&](Index other) {
        return static_cast<float>((state.position.at(other) - state.position.at(mass)).norm());
      };
      if (column + 1 < sheet.columns) sum.x += distance(mass + 1);
      if (row + 1 < sheet.rows) sum.y += distance(mass + sheet.columns);
    }
  return sum / glm::vec2(sheet.rows * (sheet.columns - 1), sheet.columns * (sheet.rows - 1));
}

/// Sums each triangle's normal, as long as twice its area, into its corners.
void add_normals(SurfaceMesh& mesh) {
  const std::vector<Index>& indices = *mesh.indices;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    SurfaceVertex& a = mesh.vertices[indices[i]];
    SurfaceVertex& b = mesh.vertices[indices[i + 1]];
    SurfaceVertex& c = mesh.vertices[indices[i + 2]];
    const glm::vec3 normal = glm::cross(b.position - a.position, c.position - a.position);
    a.normal += normal;
    b.normal += normal;
    c.normal += normal;
  }
  for (SurfaceVertex& vertex : mesh.vertices) {
    const float length = glm::length(vertex.normal);
    vertex.normal = length > 0.0F ? vertex.normal / length : glm::vec3(0, 1, 0);
  }
}

/// Calls with (vertex, neighbour) both ways along each edge of each triangle.
template <typename Visit>
void for_each_neighbour(const std::vector<Index>& indices, const Visit& visit) {
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = indices[i + k], to = indices[i + (k + 1) % 3];
      visit(from, to);
      visit(to, from);
    }
  }
}

/// How far the neighbours' mean lies in front of each vertex, in edge lengths, averaged once more over the
/// neighbours: a cheap stand-in for how much of the sky a fold hides.
void add_hollows(SurfaceMesh& mesh) {
  constexpr float gain = 14.0F;
  const std::size_t count = mesh.vertices.size();
  std::vector<glm::vec4> sum(count, glm::vec4(0.0F));  // towards the neighbours; w: lengths
  for_each_neighbour(*mesh.indices, [&](Index from, Index to) {
    const glm::vec3 edge = mesh.vertices[to].position - mesh.vertices[from].position;
    sum[from] += glm::vec4(edge, glm::length(edge));
  });
  std::vector<float> own(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (sum[i].w > 0.0F) own[i] = gain * glm::dot(glm::vec3(sum[i]), mesh.vertices[i].normal) / sum[i].w;
  }
  std::vector<glm::vec2> around(count, glm::vec2(0.0F));  // sum of the neighbours' values, their number
  for_each_neighbour(*mesh.indices, [&](Index from, Index to) { around[from] += glm::vec2(own[to], 1.0F); });
  for (std::size_t i = 0; i < count; ++i) {
    const float neighbours = around[i].y > 0.0F ? around[i].x / around[i].y : 0.0F;
    const float hollow = 0.5F * (own[i] + neighbours);
    mesh.vertices[i].hollow = hollow / (1.0F + std::abs(hollow));
  }
}

}  // namespace

bool is_whole(const Triangle& triangle, const State& state) {
  return std::none_of(triangle.links.begin(), triangle.links.end(),
                      [&state](Index link) { return link != no_link && state.broken(link); });
}

SharedPattern pattern_positions(const Model& model, Pattern pattern) {
  std::vector<glm::vec2> positions(model.masses.size(), glm::vec2(0.0F));
  for (const Sheet& sheet : model.sheets) {
    const float units = units_per_cell(sheet, pattern);
    for (Index row = 0; row < sheet.rows; ++row) {
      for (Index column = 0; column < sheet.columns; ++column) {
        positions[sheet.first_mass + row * sheet.columns + column] =
            units * glm::vec2(static_cast<float>(column), static_cast<float>(row));
      }
    }
  }
  return std::make_shared<const std::vector<glm::vec2>>(std::move(positions));
}

SpreadSheets spread_sheets(const Model& model, const State& start) {
  SpreadSheets spread;
  spread.positions.resize(model.masses.size());
  Index rows = 0, columns = 0;
  for (const Sheet& sheet : model.sheets) {
    for (Index row = 0; row < sheet.rows; ++row)
      for (Index column = 0; column < sheet.columns; ++column)
        spread.positions[sheet.first_mass + row * sheet.columns + column] = glm::vec2(column, rows + row);
    spread.cell_size = glm::max(spread.cell_size, mean_cell(sheet, start));
    rows += sheet.rows;
    columns = std::max(columns, sheet.columns);
  }
  spread.masses = {static_cast<int>(columns), static_cast<int>(rows)};
  return spread;
}

std::vector<glm::vec4> light_places(const SurfaceMesh& mesh, const glm::mat4& to_map,
                                    const glm::vec3& to_light, float texel) {
  const auto columns = static_cast<std::size_t>(mesh.spread->masses.width);
  std::vector<glm::vec4> places(columns * static_cast<std::size_t>(mesh.spread->masses.height));
  for (std::size_t mass = 0; mass < mesh.vertices.size(); ++mass) {
    const SurfaceVertex& vertex = mesh.vertices[mass];
    const glm::vec2& at = mesh.spread->positions[mass];
    const float side = glm::dot(vertex.normal, to_light) < 0.0F ? -1.0F : 1.0F;
    const glm::vec3 lifted = vertex.position + texel * (1.5F * side * vertex.normal + to_light);
    places[static_cast<std::size_t>(at.y) * columns + static_cast<std::size_t>(at.x)] =
        to_map * glm::vec4(lifted, 1.0F);
  }
  return places;
}

SharedIndices whole_triangles(const Model& model, const State& state, const SharedIndices& before) {
  std::vector<Index> indices;
  indices.reserve(3 * model.triangles.size());
  for (const Triangle& triangle : model.triangles)
    if (is_whole(triangle, state))
      indices.insert(indices.end(), triangle.masses.begin(), triangle.masses.end());
  if (before && *before == indices) return before;
  return std::make_shared<const std::vector<Index>>(std::move(indices));
}

SurfaceMesh surface_mesh(const SharedIndices& triangles, const State& state, const Quantity& quantity,
                         const ColourScale& scale) {
  SurfaceMesh mesh;
  mesh.indices = triangles;
  mesh.vertices.reserve(state.position.size());
  for (std::size_t mass = 0; mass < state.position.size(); ++mass)
    mesh.vertices.push_back({to_glm(state.position.at(mass)), glm::vec3(0.0F), 0.0F});
  mesh.colours.reserve(quantity.of_mass.size());
  for (const double value : quantity.of_mass) mesh.colours.push_back(opaque(scale.at(value)));
  add_normals(mesh);
  add_hollows(mesh);
  return mesh;
}

}  // namespace taut
