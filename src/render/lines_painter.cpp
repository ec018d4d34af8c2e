#include "lines_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace taut {
namespace {

constexpr std::array rope_attributes{Attribute{4, GL_FLOAT, offsetof(RopeRecord, start)},
                                     Attribute{4, GL_FLOAT, offsetof(RopeRecord, end)},
                                     Attribute{3, GL_FLOAT, offsetof(RopeRecord, start_tangent)},
                                     Attribute{3, GL_FLOAT, offsetof(RopeRecord, end_tangent)},
                                     Attribute{2, GL_FLOAT, offsetof(RopeRecord, phases)},
                                     Attribute{4, GL_UNSIGNED_BYTE, offsetof(RopeRecord, start_colour)},
                                     Attribute{4, GL_UNSIGNED_BYTE, offsetof(RopeRecord, end_colour)}};
constexpr std::array ring_attributes{Attribute{4, GL_FLOAT, offsetof(RingRecord, start)},
                                     Attribute{4, GL_FLOAT, offsetof(RingRecord, end)},
                                     Attribute{3, GL_FLOAT, offsetof(RingRecord, side)},
                                     Attribute{4, GL_UNSIGNED_BYTE, offsetof(RingRecord, colour)}};
constexpr std::array arrow_attributes{Attribute{4, GL_FLOAT, offsetof(RodRecord, start)},
                                      Attribute{3, GL_FLOAT, offsetof(RodRecord, end)},
                                      Attribute{4, GL_UNSIGNED_BYTE, offsetof(RodRecord, colour)}};
constexpr std::array mesh_attributes{Attribute{4, GL_FLOAT, 0}};

// A ring as a grid: round each half circle in so many pieces, and around the wire. A wire of up to so many
// pixels is drawn with it.
struct Grid {
  int bend, sides;
  float most_pixels;
};
// The first one is for shadows, of whatever size.
constexpr std::array ring_grids{Grid{3, 3, 0.0F},  Grid{4, 5, 3.0F},    Grid{5, 6, 6.0F},
                                Grid{7, 9, 12.0F}, Grid{12, 14, 30.0F}, Grid{20, 24, 1e9F}};

constexpr int arrow_sides = 24;

float turn(int step, int steps) {
  return 2.0F * std::numbers::pi_v<float> * static_cast<float>(step) / static_cast<float>(steps);
}

// Two triangles for each place of a grid of which rows and columns both come round again, or rows end.
void add_quads(std::vector<GLuint>& triangles, int rows, int columns, bool rows_come_round) {
  const auto at = [&](int row, int column) {
    return static_cast<GLuint>((row % rows) * columns + column % columns);
  };
  for (int row = 0; row < rows - (rows_come_round ? 0 : 1); ++row)
    for (int column = 0; column < columns; ++column)
      for (const GLuint corner : {at(row, column), at(row, column + 1), at(row + 1, column),
                                  at(row + 1, column), at(row, column + 1), at(row + 1, column + 1)})
        triangles.push_back(corner);
}

// x, y: the half circles as angles from −90° to 90° about the end, as cosine and sine, the start's marked by
// a cosine below 0; z, w: around the wire, as cosine and sine.
MeshPainter::Mesh ring_mesh(const Grid& grid) {
  MeshPainter::Mesh mesh;
  for (const float half : {1.0F, -1.0F})
    for (int i = 0; i <= grid.bend; ++i) {
      const float bend =
          std::numbers::pi_v<float> * (static_cast<float>(i) / static_cast<float>(grid.bend) - 0.5F);
      for (int side = 0; side < grid.sides; ++side)
        // At the very ends of a half circle the cosine must still tell which half it is.
        mesh.vertices.emplace_back(half * std::max(std::cos(bend), 1e-6F), half * std::sin(bend),
                                   std::cos(turn(side, grid.sides)), -std::sin(turn(side, grid.sides)));
    }
  add_quads(mesh.triangles, 2 * (grid.bend + 1), grid.sides, true);
  return mesh;
}

// Rows of an arrow, from its tail to its tip, each with a normal of its own; see shaders/arrow.vert.
MeshPainter::Mesh arrow_mesh() {
  MeshPainter::Mesh mesh;
  constexpr int rows = 8;
  for (int row = 0; row < rows; ++row)
    for (int side = 0; side < arrow_sides; ++side)
      mesh.vertices.emplace_back(std::cos(turn(side, arrow_sides)), std::sin(turn(side, arrow_sides)),
                                 static_cast<float>(row), 0.0F);
  add_quads(mesh.triangles, rows, arrow_sides, false);
  return mesh;
}

std::vector<MeshPainter::Mesh> ring_meshes() {
  std::vector<MeshPainter::Mesh> meshes;
  meshes.reserve(ring_grids.size());
  for (const Grid& grid : ring_grids) meshes.push_back(ring_mesh(grid));
  return meshes;
}

}  // namespace

MeshPainter::Level::Level(const Gl& gl, const Mesh& mesh, std::size_t record_size,
                          std::span<const Attribute> attributes)
    : array(make_vertex_array(gl)),
      vertices(gl, array, sizeof(glm::vec4), mesh_attributes, 0),
      records(gl, array, record_size, attributes, 1, 1),
      triangles(gl) {
  vertices.upload(std::span(mesh.vertices));
  triangles.upload(mesh.triangles);
}

MeshPainter::MeshPainter(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
                         const Defines& defines, const std::vector<Mesh>& meshes, std::size_t record_size,
                         std::span<const Attribute> attributes)
    : gl_(&gl), programs_(gl, library, shaders, defines) {
  for (const Mesh& mesh : meshes) levels_.emplace_back(gl, mesh, record_size, attributes);
}

void MeshPainter::draw(Pass pass, std::size_t first, std::size_t count) const {
  (pass == Pass::colour ? programs_.colour : programs_.shadow).use();
  for (const Level& level : std::span(levels_).subspan(first, count)) {
    if (level.records.count() == 0) continue;
    gl_->bind_vertex_array(level.array.name());
    level.triangles.bind();
    gl_->draw_elements_instanced(GL_TRIANGLES, level.triangles.count(), GL_UNSIGNED_INT, nullptr,
                                 level.records.count());
  }
}

void LinesPainter::upload(const Lines& lines, float pixel) {
  if (!ropes_ && !lines.ropes.empty())
    ropes_.emplace(gl_, library_, PainterShaders{"rope.vert", "rope.frag", "nothing.frag"}, defines_,
                   sizeof(RopeRecord), rope_attributes);
  if (!ghosts_ && !lines.ghosts.empty()) ghosts_.emplace(link_painter(gl_, library_, defines_));
  if (!rings_ && !lines.rings.empty())
    rings_.emplace(gl_, library_, PainterShaders{"ring.vert", "ring.frag", "nothing.frag"}, defines_,
                   ring_meshes(), sizeof(RingRecord), ring_attributes);
  if (!arrows_ && !lines.arrows.empty())
    arrows_.emplace(gl_, library_, PainterShaders{"arrow.vert", "body.frag", "nothing.frag"}, defines_,
                    std::vector<MeshPainter::Mesh>{arrow_mesh()}, sizeof(RodRecord), arrow_attributes);
  if (ropes_) ropes_->upload(lines.ropes);
  if (ghosts_) ghosts_->upload(lines.ghosts);
  if (rings_) upload_rings(lines.rings, pixel);
  if (arrows_) arrows_->upload(0, lines.arrows);
}

void LinesPainter::upload_rings(const std::vector<RingRecord>& rings, float pixel) {
  std::array<std::vector<RingRecord>, ring_grids.size()> sorted;
  for (const RingRecord& ring : rings) {
    const float depth = std::min(glm::length(ring.start), glm::length(ring.end));
    const float pixels = 2.0F * ring.wire_radius / std::max(pixel * depth, 1e-6F);
    std::size_t which = 1;
    while (pixels > ring_grids[which].most_pixels) ++which;
    sorted[which].push_back(ring);
  }
  rings_->upload(0, rings);
  for (std::size_t i = 1; i < sorted.size(); ++i) rings_->upload(i, sorted[i]);
}

void LinesPainter::draw_shadows() const {
  if (ropes_) ropes_->draw(Pass::shadow);
  if (rings_) rings_->draw(Pass::shadow, 0, 1);
}

void LinesPainter::draw_solid() const {
  if (rings_) rings_->draw(Pass::colour, 1, ring_grids.size() - 1);
  if (arrows_) arrows_->draw(Pass::colour, 0, 1);
}

void LinesPainter::draw_ribbons() const {
  if (ropes_) ropes_->draw(Pass::colour);
  if (ghosts_) ghosts_->draw(Pass::colour);
}

}  // namespace taut
