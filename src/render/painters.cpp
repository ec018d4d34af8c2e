#include "painters.h"

#include <array>
#include <cstddef>

namespace taut {
namespace {

constexpr std::array sphere_attributes{Attribute{4, GL_FLOAT, offsetof(SphereRecord, centre)},
                                       Attribute{4, GL_UNSIGNED_BYTE, offsetof(SphereRecord, colour)}};
constexpr std::array link_attributes{Attribute{4, GL_FLOAT, offsetof(LinkRecord, start)},
                                     Attribute{3, GL_FLOAT, offsetof(LinkRecord, end)},
                                     Attribute{4, GL_UNSIGNED_BYTE, offsetof(LinkRecord, colour)}};
constexpr std::array surface_attributes{Attribute{3, GL_FLOAT, offsetof(SurfaceVertex, position)},
                                        Attribute{3, GL_FLOAT, offsetof(SurfaceVertex, normal)},
                                        Attribute{2, GL_FLOAT, offsetof(SurfaceVertex, pattern_position)},
                                        Attribute{4, GL_UNSIGNED_BYTE, offsetof(SurfaceVertex, colour)},
                                        Attribute{1, GL_FLOAT, offsetof(SurfaceVertex, hollow)}};

constexpr std::array solid_attributes{Attribute{3, GL_FLOAT, offsetof(SolidVertex, position)},
                                      Attribute{3, GL_FLOAT, offsetof(SolidVertex, normal)},
                                      Attribute{4, GL_UNSIGNED_BYTE, offsetof(SolidVertex, colour)}};

// Replaces a mesh's vertices and indices; gives the number of indices.
template <typename Mesh>
GLsizei upload_mesh(const Gl& gl, VertexStream& stream, const GlObject& index_buffer, const Mesh& mesh) {
  stream.upload(std::span(mesh.vertices));
  stream.bind();
  gl.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer.name());
  const auto bytes = std::as_bytes(std::span(mesh.indices));
  gl.buffer_data(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                 GL_STREAM_DRAW);
  return static_cast<GLsizei>(mesh.indices.size());
}

void set_colour(const Program& program, const char* uniform, const Colour& colour) {
  program.set(uniform, static_cast<float>(colour[0]), static_cast<float>(colour[1]),
              static_cast<float>(colour[2]));
}

}  // namespace

SpherePainter::SpherePainter(const Gl& gl, const ShaderLibrary& library)
    : gl_(&gl),
      colour_(gl, library, "sphere.vert", "sphere.frag"),
      shadow_(gl, library, "sphere.vert", "sphere_shadow.frag"),
      stream_(gl, sizeof(SphereRecord), sphere_attributes, 1) {}

void SpherePainter::draw_with(const Program& program) const {
  program.use();
  stream_.bind();
  gl_->draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, stream_.count());
}

LinkPainter::LinkPainter(const Gl& gl, const ShaderLibrary& library)
    : gl_(&gl),
      colour_(gl, library, "link.vert", "link.frag"),
      shadow_(gl, library, "link.vert", "nothing.frag"),
      stream_(gl, sizeof(LinkRecord), link_attributes, 1) {}

void LinkPainter::draw_with(const Program& program) const {
  program.use();
  stream_.bind();
  gl_->draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, stream_.count());
}

SurfacePainter::SurfacePainter(const Gl& gl, const ShaderLibrary& library, const Look& look)
    : gl_(&gl),
      colour_(gl, library, "surface.vert", "surface.frag"),
      shadow_(gl, library, "surface.vert", "nothing.frag"),
      stream_(gl, sizeof(SurfaceVertex), surface_attributes, 0),
      index_buffer_(make_buffer(gl)) {
  colour_.use();
  set_colour(colour_, "front_colour", look.surface_colour);
  set_colour(colour_, "back_colour", look.surface_back_colour);
  colour_.set("pattern", static_cast<int>(look.pattern));
}

void SurfacePainter::upload(const SurfaceMesh& mesh) {
  index_count_ = upload_mesh(*gl_, stream_, index_buffer_, mesh);
}

void SurfacePainter::draw_with(const Program& program) const {
  program.use();
  stream_.bind();
  gl_->draw_elements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

SolidPainter::SolidPainter(const Gl& gl, const ShaderLibrary& library)
    : gl_(&gl),
      colour_(gl, library, "solid.vert", "solid.frag"),
      shadow_(gl, library, "solid.vert", "nothing.frag"),
      stream_(gl, sizeof(SolidVertex), solid_attributes, 0),
      index_buffer_(make_buffer(gl)) {}

void SolidPainter::upload(const SolidMesh& mesh) {
  index_count_ = upload_mesh(*gl_, stream_, index_buffer_, mesh);
}

void SolidPainter::draw_with(const Program& program) const {
  program.use();
  stream_.bind();
  gl_->draw_elements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

BackdropPainter::BackdropPainter(const Gl& gl, const ShaderLibrary& library)
    : gl_(&gl),
      ground_(gl, library, "ground.vert", "ground.frag"),
      sky_(gl, library, "sky.vert", "sky.frag"),
      no_attributes_(make_vertex_array(gl)) {}

void BackdropPainter::draw_ground() const {
  ground_.use();
  gl_->bind_vertex_array(no_attributes_.name());
  gl_->draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
}

void BackdropPainter::draw_sky(const glm::vec3& right, const glm::vec3& down) const {
  sky_.use();
  sky_.set("right", right.x, right.y, right.z);
  sky_.set("down", down.x, down.y, down.z);
  gl_->bind_vertex_array(no_attributes_.name());
  gl_->draw_arrays(GL_TRIANGLES, 0, 3);
}

}  // namespace taut
