#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "gl/gl.h"

namespace taut {

/// Owns one OpenGL object and deletes it in the end. The context must be current then.
class GlObject {
 public:
  GlObject() = default;
  GlObject(GLuint name, std::function<void(GLuint)> remove) : name_(name), remove_(std::move(remove)) {}
  GlObject(GlObject&& other) noexcept
      : name_(std::exchange(other.name_, 0)), remove_(std::move(other.remove_)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(remove_, other.remove_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) remove_(name_);
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
  std::function<void(GLuint)> remove_;
};

GlObject make_buffer(const Gl& gl);
GlObject make_vertex_array(const Gl& gl);
GlObject make_texture(const Gl& gl);
GlObject make_framebuffer(const Gl& gl);
GlObject make_renderbuffer(const Gl& gl);

/// One vertex attribute inside an interleaved record.
struct Attribute {
  GLint components;
  GLenum type;         ///< GL_FLOAT, or GL_UNSIGNED_BYTE (read as 0 to 1)
  std::size_t offset;  ///< bytes from the record's start
};

/// Records in a buffer, and how a vertex shader reads them at locations first, first + 1, …
class VertexStream {
 public:
  /// Becomes part of a vertex array. `divisor` 0: a record a vertex; 1: a record an instance.
  VertexStream(const Gl& gl, const GlObject& array, std::size_t record_size,
               std::span<const Attribute> attributes, GLuint divisor, GLuint first = 0);

  /// Replaces the contents.
  template <typename Record>
  void upload(std::span<const Record> records) {
    upload_bytes(std::as_bytes(records));
    count_ = static_cast<GLsizei>(records.size());
  }
  GLsizei count() const { return count_; }

 private:
  void upload_bytes(std::span<const std::byte> bytes);

  const Gl* gl_;
  GlObject buffer_;
  GLsizei count_ = 0;
};

/// Corners of triangles, as numbers of vertices.
class IndexStream {
 public:
  explicit IndexStream(const Gl& gl) : gl_(&gl), buffer_(make_buffer(gl)) {}

  /// Replaces the contents.
  void upload(std::span<const GLuint> indices);
  /// Makes them those of the vertex array that is bound.
  void bind() const { gl_->bind_buffer(GL_ELEMENT_ARRAY_BUFFER, buffer_.name()); }
  GLsizei count() const { return count_; }

 private:
  const Gl* gl_;
  GlObject buffer_;
  GLsizei count_ = 0;
};

}  // namespace taut
