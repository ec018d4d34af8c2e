#include "gl/gl_objects.h"

namespace taut {
namespace {

using Make = void(APIENTRYP)(GLsizei, GLuint*);
using Delete = void(APIENTRYP)(GLsizei, const GLuint*);

GlObject make_object(Make make, Delete remove) {
  GLuint name = 0;
  make(1, &name);
  return {name, [remove](GLuint old) { remove(1, &old); }};
}

}  // namespace

GlObject make_buffer(const Gl& gl) {
  return make_object(gl.make_buffers, gl.delete_buffers);
}
GlObject make_vertex_array(const Gl& gl) {
  return make_object(gl.make_vertex_arrays, gl.delete_vertex_arrays);
}
GlObject make_texture(const Gl& gl) {
  return make_object(gl.make_textures, gl.delete_textures);
}
GlObject make_framebuffer(const Gl& gl) {
  return make_object(gl.make_framebuffers, gl.delete_framebuffers);
}
GlObject make_renderbuffer(const Gl& gl) {
  return make_object(gl.make_renderbuffers, gl.delete_renderbuffers);
}

VertexStream::VertexStream(const Gl& gl, const GlObject& array, std::size_t record_size,
                           std::span<const Attribute> attributes, GLuint divisor, GLuint first)
    : gl_(&gl), buffer_(make_buffer(gl)) {
  gl.bind_vertex_array(array.name());
  gl.bind_buffer(GL_ARRAY_BUFFER, buffer_.name());
  for (GLuint i = 0; i < attributes.size(); ++i) {
    const Attribute& attribute = attributes[i];
    gl.enable_attribute(first + i);
    gl.attribute_pointer(first + i, attribute.components, attribute.type,
                         attribute.type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE,
                         static_cast<GLsizei>(record_size), reinterpret_cast<const void*>(attribute.offset));
    gl.attribute_divisor(first + i, divisor);
  }
}

void VertexStream::upload_bytes(std::span<const std::byte> bytes) {
  gl_->bind_buffer(GL_ARRAY_BUFFER, buffer_.name());
  gl_->buffer_data(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
}

void IndexStream::upload(std::span<const GLuint> indices) {
  bind();
  gl_->buffer_data(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
                   GL_DYNAMIC_DRAW);
  count_ = static_cast<GLsizei>(indices.size());
}

}  // namespace taut
