#pragma once

#include <glm/glm.hpp>

#include "base/image.h"
#include "geometry/region.h"
#include "gl/gl_objects.h"

namespace taut {

/// How many of the wanted samples a pixel a context draws at once: all of them, or 4 of 8. Throws BadRequest
/// where it can't draw so many.
int samples_at_once(const Gl& gl, int wanted);

/// What the alpha of fragments says. cover: 1 wherever they are. share: of a pixel's samples, how many are to
/// be drawn (GL_SAMPLE_ALPHA_TO_COVERAGE); those are covered wholly then.
enum class Alpha { cover, share };

/// A part of a picture that is drawn or still being drawn.
class Readback {
 public:
  /// Of a framebuffer that is being drawn into.
  Readback(const Gl& gl, const GlObject& framebuffer, Size size, Alpha alpha, int bits);

  /// The part as it was drawn, samples averaged: RGBA, colour multiplied by alpha. Waits for it.
  Image fetch() const;

 private:
  const Gl* gl_;
  Size size_;
  Alpha alpha_;
  int bits_;
  GlObject colour_, framebuffer_;
};

/// A part of a picture being drawn: colour and depth, one or several samples a pixel.
class PictureTarget {
 public:
  /// `bits`: of each channel, 8 or 16. Throws BadRequest for a size that OpenGL can't draw.
  PictureTarget(const Gl& gl, Size picture, int samples, int bits);

  /// Directs drawing into this region of the picture, and empties it. Throws RunFailure when there is no
  /// memory for it.
  void begin(const Region& region, Alpha alpha = Alpha::cover);
  /// Ends that.
  Readback end();
  int samples() const { return samples_; }

 private:
  void make_room(Size size);

  const Gl* gl_;
  Size picture_, room_{0, 0};
  int samples_, bits_;
  Region region_;
  Alpha alpha_ = Alpha::cover;
  GlObject colour_, depth_, framebuffer_;
};

/// A texture of shares of the light that reach places, smooth between texels.
class LightMap {
 public:
  explicit LightMap(const Gl& gl);

  /// Directs drawing into so many texels of it, all of which have to be drawn. It grows where they are more
  /// than it has.
  void begin(Size size);
  /// Directs drawing into it so that a whole picture would cover `picture` texels, `corner` of them the
  /// first.
  void begin(Size size, const glm::ivec2& corner, Size picture);
  /// Lets shaders read it as light_map.
  void bind_for_reading() const;
  /// From texels to coordinates.
  glm::vec2 texel() const;

 private:
  const Gl* gl_;
  Size room_{0, 0};
  GlObject texture_, framebuffer_;
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
  /// Lets shaders read its depths from texture unit 2, instead.
  void bind_for_depths() const;
  int size() const { return size_; }

 private:
  const Gl* gl_;
  int size_;
  GlObject texture_, framebuffer_;
};

/// A square texture of two numbers a texel that can be averaged over parts of any size, 0 outside.
class MaskMap {
 public:
  MaskMap(const Gl& gl, int size);

  /// Directs drawing here, into so many texels from a corner on. All others are 0.
  void begin(const glm::ivec2& corner, const glm::ivec2& size) const;
  /// Ends that: works out averages over `across` texels each way, but 64 at most.
  void end(float across) const;
  /// Lets shaders read it from a texture unit.
  void bind_for_reading(GLenum unit) const;
  int size() const { return size_; }

 private:
  const Gl* gl_;
  int size_;
  GlObject texture_, framebuffer_;
};

}  // namespace taut
