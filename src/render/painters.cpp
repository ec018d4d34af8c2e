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

void set_colour(const Program& program, const char* uniform, const Colour& colour) {
  program.set(uniform, static_cast<float>(colour[0]), static_cast<float>(colour[1]),
              static_cast<float>(colour[2]));
}

void set_vector(const Program& program, const char* uniform, const glm::vec3& vector) {
  program.set(uniform, vector.x, vector.y, vector.z);
}

}  // namespace

InstancePainter::InstancePainter(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
                                 std::size_t record_size, std::span<const Attribute> attributes)
    : gl_(&gl),
      colour_(gl, library, shaders.vertex, shaders.colour),
      shadow_(gl, library, shaders.vertex, shaders.shadow),
      stream_(gl, record_size, attributes, 1) {}

void InstancePainter::draw_with(const Program& program) const {
  program.use();
  stream_.bind();
  gl_->draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, stream_.count());
}

SpherePainter::SpherePainter(const Gl& gl, const ShaderLibrary& library)
    : InstancePainter(gl, library, {"sphere.vert", "sphere.frag", "sphere_shadow.frag"}, sizeof(SphereRecord),
                      sphere_attributes) {}

LinkPainter::LinkPainter(const Gl& gl, const ShaderLibrary& library)
    : InstancePainter(gl, library, {"link.vert", "link.frag", "nothing.frag"}, sizeof(LinkRecord),
                      link_attributes) {}

MeshPainter::MeshPainter(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
                         std::size_t vertex_size, std::span<const Attribute> attributes)
    : gl_(&gl),
      colour_(gl, library, shaders.vertex, shaders.colour),
      shadow_(gl, library, shaders.vertex, shaders.shadow),
      stream_(gl, vertex_size, attributes, 0),
      index_buffer_(make_buffer(gl)) {}

void MeshPainter::upload_indices(std::span<const Index> indices) {
  stream_.bind();
  gl_->bind_buffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_.name());
  gl_->buffer_data(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
                   GL_STREAM_DRAW);
  index_count_ = static_cast<GLsizei>(indices.size());
}

void MeshPainter::draw_with(const Program& program) const {
  program.use();
  stream_.bind();
  gl_->draw_elements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

SurfacePainter::SurfacePainter(const Gl& gl, const ShaderLibrary& library, const Look& look)
    : MeshPainter(gl, library, {"surface.vert", "surface.frag", "nothing.frag"}, sizeof(SurfaceVertex),
                  surface_attributes) {
  colour().use();
  set_colour(colour(), "front_colour", look.surface_colour);
  set_colour(colour(), "back_colour", look.surface_back_colour);
  colour().set("pattern", static_cast<int>(look.pattern));
}

SolidPainter::SolidPainter(const Gl& gl, const ShaderLibrary& library)
    : MeshPainter(gl, library, {"solid.vert", "solid.frag", "nothing.frag"}, sizeof(SolidVertex),
                  solid_attributes) {}

BackdropPainter::BackdropPainter(const Gl& gl, const ShaderLibrary& library)
    : gl_(&gl),
      ground_(gl, library, "ground.vert", "ground.frag"),
      sky_(gl, library, "sky.vert", "sky.frag"),
      no_attributes_(make_vertex_array(gl)) {}

void BackdropPainter::draw_ground(const GroundPatch& patch) const {
  ground_.use();
  set_vector(ground_, "normal", patch.normal);
  set_vector(ground_, "along", patch.along);
  set_vector(ground_, "across", patch.across);
  set_vector(ground_, "foot_and_height", glm::vec3(patch.foot, patch.height));
  ground_.set("solid", patch.solid ? 1 : 0);
  gl_->bind_vertex_array(no_attributes_.name());
  gl_->draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
}

void BackdropPainter::draw_sky(const glm::vec3& right, const glm::vec3& down) const {
  sky_.use();
  set_vector(sky_, "right", right);
  set_vector(sky_, "down", down);
  gl_->bind_vertex_array(no_attributes_.name());
  gl_->draw_arrays(GL_TRIANGLES, 0, 3);
}

}  // namespace taut
