#pragma once

#include "geometry/frame_block.h"
#include "gl/gl_objects.h"

namespace taut {

/// Where all programs find the block of the pass being drawn.
class FrameUniforms {
 public:
  explicit FrameUniforms(const Gl& gl) : gl_(&gl), buffer_(make_buffer(gl)) {}

  void load(const FrameBlock& block) const {
    gl_->bind_buffer_base(GL_UNIFORM_BUFFER, 0, buffer_.name());
    gl_->buffer_data(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
  }

 private:
  const Gl* gl_;
  GlObject buffer_;
};

}  // namespace taut
