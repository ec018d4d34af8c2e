#include "painters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "geometry/palette.h"
#include "render/appearance.h"

namespace taut {
namespace {

constexpr std::array sphere_attributes{Attribute{4, GL_FLOAT, offsetof(SphereRecord, centre)},
                                       Attribute{4, GL_UNSIGNED_BYTE, offsetof(SphereRecord, colour)}};
constexpr std::array surface_attributes{Attribute{3, GL_FLOAT, offsetof(SurfaceVertex, position)},
                                        Attribute{3, GL_FLOAT, offsetof(SurfaceVertex, normal)},
                                        Attribute{2, GL_FLOAT, offsetof(SurfaceVertex, open)}};
constexpr std::array place_attributes{Attribute{2, GL_FLOAT, offsetof(SurfacePlace, pattern)},
                                      Attribute{3, GL_FLOAT, offsetof(SurfacePlace, edges)},
                                      Attribute{2, GL_FLOAT, offsetof(SurfacePlace, light)}};
constexpr std::array colour_attributes{Attribute{4, GL_UNSIGNED_BYTE, 0}};
constexpr std::array tint_attributes{Attribute{4, GL_UNSIGNED_BYTE, offsetof(SurfaceTint, front)},
                                     Attribute{4, GL_UNSIGNED_BYTE, offsetof(SurfaceTint, back)}};
constexpr std::array ball_attributes{Attribute{4, GL_FLOAT, 0}};
constexpr std::array rod_attributes{Attribute{4, GL_FLOAT, offsetof(RodRecord, start)},
                                    Attribute{3, GL_FLOAT, offsetof(RodRecord, end)},
                                    Attribute{4, GL_UNSIGNED_BYTE, offsetof(RodRecord, colour)}};
constexpr std::array taper_attributes{Attribute{4, GL_FLOAT, offsetof(TaperedRod, start)},
                                      Attribute{4, GL_FLOAT, offsetof(TaperedRod, end)},
                                      Attribute{3, GL_FLOAT, offsetof(TaperedRod, squeeze)},
                                      Attribute{4, GL_UNSIGNED_BYTE, offsetof(TaperedRod, start_colour)},
                                      Attribute{4, GL_UNSIGNED_BYTE, offsetof(TaperedRod, end_colour)},
                                      Attribute{2, GL_FLOAT, offsetof(TaperedRod, shade)}};
constexpr std::array torso_skin_attributes{Attribute{3, GL_FLOAT, offsetof(TorsoVertex, place)},
                                           Attribute{3, GL_FLOAT, offsetof(TorsoVertex, outward)}};
constexpr std::array torso_attributes{
    Attribute{3, GL_FLOAT, offsetof(TorsoRecord, origin)},
    Attribute{3, GL_FLOAT, offsetof(TorsoRecord, axes)},
    Attribute{3, GL_FLOAT, offsetof(TorsoRecord, axes) + sizeof(glm::vec3)},
    Attribute{3, GL_FLOAT, offsetof(TorsoRecord, axes) + 2 * sizeof(glm::vec3)},
    Attribute{4, GL_UNSIGNED_BYTE, offsetof(TorsoRecord, colour)},
    Attribute{2, GL_FLOAT, offsetof(TorsoRecord, shade)}};
constexpr std::array box_attributes{
    Attribute{3, GL_FLOAT, offsetof(BoxRecord, centre)},
    Attribute{3, GL_FLOAT, offsetof(BoxRecord, edges)},
    Attribute{3, GL_FLOAT, offsetof(BoxRecord, edges) + sizeof(glm::vec3)},
    Attribute{3, GL_FLOAT, offsetof(BoxRecord, edges) + 2 * sizeof(glm::vec3)},
    Attribute{4, GL_UNSIGNED_BYTE, offsetof(BoxRecord, colour)},
    Attribute{3, GL_FLOAT, offsetof(BoxRecord, shade)}};
constexpr std::array solid_attributes{Attribute{3, GL_FLOAT, offsetof(SolidVertex, position)},
                                      Attribute{3, GL_FLOAT, offsetof(SolidVertex, normal)}};
constexpr GLsizei corners_of_a_box = 36;

// How many sides a round thing may have.
constexpr std::array round_sides{8, 12, 16, 20, 24, 28, 40, 56, 80, 112};

// As many sides as keep the outline within a fourth of a pixel of the circle.
std::size_t round_for(float radius_in_pixels) {
  const float tolerance = std::clamp(0.25F / std::max(radius_in_pixels, 0.1F), 0.0F, 1.0F);
  const float sides = std::numbers::pi_v<float> / std::acos(1.0F - tolerance);
  std::size_t which = 0;
  while (which + 1 < round_sides.size() && static_cast<float>(round_sides[which]) < sides) ++which;
  return which;
}

// Circles of latitude about z from the lower tip to the upper, as shaders/rod.vert reads them; the seam is
// there thrice, for either half and in the middle between them.
std::vector<glm::vec4> ball_vertices(int sides) {
  const int rings = sides / 4;
  std::vector<glm::vec4> vertices;
  for (int ring = -rings - 1; ring <= rings + 1; ++ring) {
    const int from_seam = ring < 0 ? ring + 1 : std::max(ring - 1, 0);
    const float latitude = static_cast<float>(from_seam) / static_cast<float>(rings);
    const float end = ring < 0 ? 0.0F : ring > 0 ? 1.0F : 0.5F;
    for (int side = 0; side < sides; ++side) {
      const float longitude =
          2.0F * std::numbers::pi_v<float> * static_cast<float>(side) / static_cast<float>(sides);
      vertices.emplace_back(std::cos(longitude), std::sin(longitude), latitude, end);
    }
  }
  return vertices;
}

// Of rings of vertices, one above the other.
std::vector<GLuint> ring_triangles(int sides, int bands) {
  std::vector<GLuint> indices;
  const auto count = static_cast<GLuint>(sides);
  for (GLuint ring = 0; ring < static_cast<GLuint>(bands); ++ring)
    for (GLuint side = 0; side < count; ++side) {
      const GLuint low = ring * count, next = (side + 1) % count;
      for (const GLuint corner :
           {low + side, low + next, low + count + side, low + count + side, low + next, low + count + next})
        indices.push_back(corner);
    }
  return indices;
}

int torso_bands(int sides) {
  return 3 * sides / 4;
}

Defines with_look(Defines defines, const Look& look) {
  if (look.colour_by != ColourBy::plain)
    defines.emplace_back("PAINTED");
  else if (look.pattern != Pattern::plain)
    defines.emplace_back(look.pattern == Pattern::checker ? "PATTERN 1" : "PATTERN 2");
  if (has_own_cloth_colours(look)) defines.emplace_back("TINTED");
  return defines;
}

Defines with_faces(Defines defines) {
  defines.emplace_back("FACES");
  return defines;
}

// Texels of the light map for a cell: shadows have soft edges, so one for two pixels does, each way; fewer
// where the map would be too large.
glm::vec2 light_texels(const SpreadSheets& spread, float pixels_a_metre) {
  constexpr float pixels_a_texel = 2.5F, most = 4095.0F;
  const glm::vec2 wanted = glm::ceil(spread.cell_size * pixels_a_metre / pixels_a_texel);
  return glm::clamp(wanted, glm::vec2(1.0F),
                    glm::max(glm::floor(most / glm::vec2(spread.places.width, spread.places.height)), 1.0F));
}

const Program& program_for(const PassPrograms& programs, Pass pass) {
  return pass == Pass::colour ? programs.colour : programs.shadow;
}

}  // namespace

PassPrograms::PassPrograms(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
                           const Defines& colour_defines)
    : colour(gl, library, shaders.vertex, shaders.colour, colour_defines),
      shadow(gl, library, shaders.shadow_vertex, shaders.shadow) {}

SquarePainter::SquarePainter(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
                             const Defines& defines, std::size_t record_size,
                             std::span<const Attribute> attributes)
    : gl_(&gl),
      programs_(gl, library, shaders, defines),
      array_(make_vertex_array(gl)),
      records_(gl, array_, record_size, attributes, 1) {}

void SquarePainter::draw(Pass pass, GLsizei count) const {
  if (count == 0) return;
  program_for(programs_, pass).use();
  gl_->bind_vertex_array(array_.name());
  gl_->draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

SquarePainter sphere_painter(const Gl& gl, const ShaderLibrary& library, const Defines& defines) {
  return {gl,
          library,
          {"sphere.vert", "sphere.frag", "sphere_shadow.frag"},
          defines,
          sizeof(SphereRecord),
          sphere_attributes};
}

SquarePainter link_painter(const Gl& gl, const ShaderLibrary& library, const Defines& defines) {
  return {gl,      library,           {"link.vert", "link.frag", "nothing.frag"},
          defines, sizeof(RodRecord), rod_attributes};
}

SurfacePainter::SurfacePainter(const Gl& gl, const ShaderLibrary& library, const Look& look, Defines defines)
    : gl_(&gl),
      programs_(gl, library, {"surface.vert", "surface.frag", "nothing.frag"},
                with_look(std::move(defines), look)),
      array_(make_vertex_array(gl)),
      vertices_(gl, array_, sizeof(SurfaceVertex), surface_attributes, 0),
      places_(gl, array_, sizeof(SurfacePlace), place_attributes, 0, 3),
      indices_(gl) {
  if (look.shadows)
    light_.emplace(Light{Program(gl, library, "whole.vert", "surface_light.frag", {"SHADOWS"}),
                         {make_texture(gl), make_texture(gl), make_texture(gl)},
                         make_vertex_array(gl),
                         LightMap(gl)});
  if (look.colour_by != ColourBy::plain) colours_.emplace(gl, array_, sizeof(Rgba), colour_attributes, 0, 6);
  if (has_own_cloth_colours(look)) tints_.emplace(gl, array_, sizeof(SurfaceTint), tint_attributes, 0, 7);
}

void SurfacePainter::upload(const SurfaceMesh& mesh) {
  gl_->bind_vertex_array(array_.name());
  vertices_.upload(std::span(mesh.vertices));
  if (colours_) colours_->upload(std::span(mesh.colours));
  if (tints_) tints_->upload(std::span(mesh.tints));
  if (mesh.places != uploaded_places_) {
    places_.upload(std::span(*mesh.places));
    uploaded_places_ = mesh.places;
  }
  if (mesh.indices != uploaded_indices_) {
    indices_.upload(*mesh.indices);
    uploaded_indices_ = mesh.indices;
  }
}

void SurfacePainter::draw_light(const SurfaceMesh& mesh, const FrameBlock& block, float pixels_a_metre) {
  const SpreadSheets& spread = *mesh.spread;
  const std::vector<glm::vec4> places =
      light_places(mesh, block.shadow_matrix, direction_to_light(), block.shadow.z);
  gl_->active_texture(GL_TEXTURE2);
  gl_->bind_texture(GL_TEXTURE_2D, light_->places.at(light_->turn++ % light_->places.size()).name());
  gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_->texture_image(GL_TEXTURE_2D, 0, GL_RGBA32F, spread.places.width, spread.places.height, 0, GL_RGBA,
                     GL_FLOAT, places.data());

  const glm::vec2 texels_a_cell = light_texels(spread, pixels_a_metre);
  const glm::vec2 size = glm::vec2(spread.places.width - 1, spread.places.height - 1) * texels_a_cell + 1.0F;
  light_->map.begin({static_cast<int>(size.x), static_cast<int>(size.y)});
  light_->program.use();
  light_->program.set("places", 2);
  light_->program.set("texels_a_cell", glm::vec3(texels_a_cell, 0.0F));
  gl_->bind_vertex_array(light_->no_attributes.name());
  gl_->draw_arrays(GL_TRIANGLES, 0, 3);

  programs_.colour.use();
  programs_.colour.set("texels_a_cell", glm::vec3(texels_a_cell, 0.0F));
  programs_.colour.set("light_texel", glm::vec3(light_->map.texel(), 0.0F));
}

void SurfacePainter::draw(Pass pass) const {
  if (indices_.count() == 0) return;
  program_for(programs_, pass).use();
  if (light_) light_->map.bind_for_reading();
  gl_->bind_vertex_array(array_.name());
  indices_.bind();
  gl_->draw_elements(GL_TRIANGLES, indices_.count(), GL_UNSIGNED_INT, nullptr);
}

RodPainter::Round::Round(const Gl& gl, int round)
    : sides(round),
      array(make_vertex_array(gl)),
      ball(gl, array, sizeof(glm::vec4), ball_attributes, 0),
      rods(gl, array, sizeof(TaperedRod), taper_attributes, 1, 1),
      triangles(gl) {
  const std::vector<glm::vec4> vertices = ball_vertices(sides);
  ball.upload(std::span(vertices));
  triangles.upload(ring_triangles(sides, 2 * (sides / 4) + 2));
}

RodPainter::RodPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines)
    : gl_(&gl),
      programs_(gl, library, {"rod.vert", "body.frag", "rod_shadow.frag", "rod_shadow.vert"}, defines) {
  for (const int sides : round_sides) rounds_.emplace_back(gl, sides);
}

void RodPainter::upload(const std::vector<TaperedRod>& rods, float pixel) {
  std::vector<std::vector<TaperedRod>> sorted(rounds_.size());
  for (const TaperedRod& rod : rods) {
    const float radius = std::max(rod.start_radius, rod.end_radius);
    const float depth = std::min(glm::length(rod.start), glm::length(rod.end)) - radius;
    // A flat ball shows its whole outline from one side only.
    const float shown = radius * std::sqrt(1.0F - glm::dot(rod.squeeze, rod.squeeze));
    sorted[round_for(shown / std::max(pixel * depth, 1e-6F))].push_back(rod);
  }
  for (std::size_t i = 0; i < rounds_.size(); ++i)
    rounds_[i].rods.upload(std::span(std::as_const(sorted[i])));
}

void RodPainter::draw(Pass pass) const {
  const Program& program = program_for(programs_, pass);
  program.use();
  for (const Round& round : rounds_) {
    if (round.rods.count() == 0) continue;
    program.set("grid", glm::vec3(round.sides, 0.0F, 0.0F));
    gl_->bind_vertex_array(round.array.name());
    round.triangles.bind();
    if (pass == Pass::shadow)
      gl_->draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, round.rods.count());
    else
      gl_->draw_elements_instanced(GL_TRIANGLES, round.triangles.count(), GL_UNSIGNED_INT, nullptr,
                                   round.rods.count());
  }
}

TorsoPainter::Skin::Skin(const Gl& gl, int round)
    : sides(round),
      array(make_vertex_array(gl)),
      skin(gl, array, sizeof(TorsoVertex), torso_skin_attributes, 0),
      torsos(gl, array, sizeof(TorsoRecord), torso_attributes, 1, 2),
      triangles(gl) {
  const std::vector<TorsoVertex> vertices = torso_vertices(sides, torso_bands(sides));
  skin.upload(std::span(vertices));
  triangles.upload(ring_triangles(sides, torso_bands(sides)));
}

TorsoPainter::TorsoPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines)
    : gl_(&gl),
      programs_(gl, library, {"torso.vert", "body.frag", "nothing.frag"}, defines),
      for_shadow_(gl, 16) {
  for (const int sides : round_sides) skins_.emplace_back(gl, sides);
}

void TorsoPainter::upload(const std::vector<TorsoRecord>& torsos, float pixel) {
  std::vector<std::vector<TorsoRecord>> sorted(skins_.size());
  for (const TorsoRecord& torso : torsos) {
    // Shoulders and hips are about a fifth of the height in radius.
    const float radius = 0.2F * glm::length(torso.axes[0]);
    sorted[round_for(radius / std::max(pixel * (glm::length(torso.origin) - radius), 1e-6F))].push_back(
        torso);
  }
  for (std::size_t i = 0; i < skins_.size(); ++i)
    skins_[i].torsos.upload(std::span(std::as_const(sorted[i])));
  // A coarse skin that reached out of the fine one would throw shadows on it.
  std::vector<TorsoRecord> slim = torsos;
  for (TorsoRecord& torso : slim)
    for (glm::vec3* axis : {&torso.axes[0], &torso.axes[2]}) *axis *= 0.9F;
  for_shadow_.torsos.upload(std::span(std::as_const(slim)));
}

void TorsoPainter::draw(Pass pass) const {
  if (for_shadow_.torsos.count() == 0) return;
  const Program& program = program_for(programs_, pass);
  program.use();
  for (const Skin& skin : pass == Pass::shadow ? std::span(&for_shadow_, 1) : std::span(skins_)) {
    if (skin.torsos.count() == 0) continue;
    program.set("grid", glm::vec3(skin.sides, torso_bands(skin.sides), 0.0F));
    gl_->bind_vertex_array(skin.array.name());
    skin.triangles.bind();
    gl_->draw_elements_instanced(GL_TRIANGLES, skin.triangles.count(), GL_UNSIGNED_INT, nullptr,
                                 skin.torsos.count());
  }
}

SolidPainter::Stored::Stored(const Gl& gl, const std::shared_ptr<const SolidSurface>& of)
    : surface(of),
      array(make_vertex_array(gl)),
      vertices(gl, array, sizeof(SolidVertex), solid_attributes, 0),
      triangles(gl) {
  vertices.upload(std::span(of->vertices));
  triangles.upload(std::span(of->triangles));
}

SolidPainter::SolidPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines)
    : gl_(&gl), programs_(gl, library, {"solid.vert", "body.frag", "nothing.frag"}, defines) {}

void SolidPainter::upload(const std::vector<MeshRecord>& meshes) {
  drawn_ = meshes;
  which_.clear();
  for (const MeshRecord& mesh : drawn_) {
    const auto known = std::ranges::find(stored_, mesh.surface, &Stored::surface);
    which_.push_back(static_cast<std::size_t>(known - stored_.begin()));
    if (known == stored_.end()) stored_.emplace_back(*gl_, mesh.surface);
  }
}

void SolidPainter::draw(Pass pass) const {
  const Program& program = program_for(programs_, pass);
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const MeshRecord& mesh = drawn_[i];
    const Stored& stored = stored_[which_[i]];
    program.use();
    program.set("centre", mesh.centre);
    program.set("axis_x", mesh.axes[0]);
    program.set("axis_y", mesh.axes[1]);
    program.set("axis_z", mesh.axes[2]);
    program.set("shade", glm::vec3(mesh.shade, mesh.shade, 0.0F));
    program.set("own_colour", glm::vec3(mesh.colour[0], mesh.colour[1], mesh.colour[2]) / 255.0F);
    gl_->bind_vertex_array(stored.array.name());
    stored.triangles.bind();
    gl_->draw_elements(GL_TRIANGLES, stored.triangles.count(), GL_UNSIGNED_INT, nullptr);
  }
}

BoxPainter::BoxPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines)
    : gl_(&gl),
      programs_(gl, library, {"box.vert", "body.frag", "nothing.frag"}, with_faces(defines)),
      array_(make_vertex_array(gl)),
      records_(gl, array_, sizeof(BoxRecord), box_attributes, 1) {}

void BoxPainter::draw(Pass pass) const {
  if (records_.count() == 0) return;
  program_for(programs_, pass).use();
  gl_->bind_vertex_array(array_.name());
  gl_->draw_arrays_instanced(GL_TRIANGLES, 0, corners_of_a_box, records_.count());
}

}  // namespace taut
