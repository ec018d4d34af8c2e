#pragma once

#include "base/image.h"
#include "gl_objects.h"

namespace taut {

/// The picture being drawn: colour and depth, one or four samples a pixel.
class PictureTarget {
 public:
  /// Throws BadRequest for a size that OpenGL can't draw, RunFailure when there is no memory for it.
  PictureTarget(const Gl& gl, Size size, int samples);

  /// Directs drawing here.
  void bind() const;

  /// The finished picture, samples averaged. RGBA comes with straight alpha.
  Image read(int channels) const;

 private:
  const Gl* gl_;
  Size size_;
  int samples_;
  GlObject colour_, depth_, framebuffer_;
  GlObject resolved_colour_, resolved_framebuffer_;  // only used with several samples
};

/// A square depth texture that compares on reading.
class ShadowMap {
 public:
  /// Throws BadRequest for a size that OpenGL can't draw.
  ShadowMap(const Gl& gl, int size);

  /// Directs drawing here.
  void bind() const;
  /// Lets shaders read it as shadow_map.
  void bind_for_reading() const;
  int size() const { return size_; }

 private:
  const Gl* gl_;
  int size_;
  GlObject texture_, framebuffer_;
};

}  // namespace taut
