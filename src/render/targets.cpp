#include "targets.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/failure.h"

namespace taut {
namespace {

GLint limit(const Gl& gl, GLenum name) {
  std::array<GLint, 2> values{};
  gl.get_integers(name, values.data());
  return name == GL_MAX_VIEWPORT_DIMS ? std::min(values[0], values[1]) : values[0];
}

void check_side(const Gl& gl, int side, const std::string& what) {
  const GLint most = std::min(
      {limit(gl, GL_MAX_RENDERBUFFER_SIZE), limit(gl, GL_MAX_TEXTURE_SIZE), limit(gl, GL_MAX_VIEWPORT_DIMS)});
  if (side >= 1 && side <= most) return;
  throw BadRequest(what + " of " + std::to_string(side) + " pixels can't be drawn: at least 1, at most " +
                   std::to_string(most));
}

GlObject renderbuffer(const Gl& gl, GLenum format, Size size, int samples) {
  GlObject buffer = make_renderbuffer(gl);
  gl.bind_renderbuffer(GL_RENDERBUFFER, buffer.name());
  gl.renderbuffer_storage(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, size.width, size.height);
  check_gl(gl, "making a picture buffer");
  return buffer;
}

void check_framebuffer(const Gl& gl) {
  if (gl.framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw RunFailure("OpenGL can't draw into a framebuffer of this size and kind");
  }
}

GlObject framebuffer(const Gl& gl, const GlObject& colour, const GlObject* depth) {
  GlObject made = make_framebuffer(gl);
  gl.bind_framebuffer(GL_FRAMEBUFFER, made.name());
  gl.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.name());
  if (depth != nullptr) {
    gl.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth->name());
  }
  check_framebuffer(gl);
  return made;
}

/// Averaging samples has mixed colours with nothing; divides them by the share that was covered.
void straighten_alpha(Image& image) {
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const unsigned alpha = image.pixels[i + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t channel = i; channel < i + 3; ++channel) {
      const unsigned straight = (image.pixels[channel] * 255U + alpha / 2) / alpha;
      image.pixels[channel] = static_cast<std::uint8_t>(std::min(straight, 255U));
    }
  }
}

}  // namespace

PictureTarget::PictureTarget(const Gl& gl, Size size, int samples)
    : gl_(&gl), size_(size), samples_(samples) {
  check_side(gl, size.width, "a picture width");
  check_side(gl, size.height, "a picture height");
  if (samples < 1 || samples > limit(gl, GL_MAX_SAMPLES)) {
    throw BadRequest(std::to_string(samples) + " samples a pixel can't be drawn: at least 1, at most " +
                     std::to_string(limit(gl, GL_MAX_SAMPLES)));
  }
  colour_ = renderbuffer(gl, GL_RGBA8, size, samples);
  depth_ = renderbuffer(gl, GL_DEPTH_COMPONENT24, size, samples);
  framebuffer_ = framebuffer(gl, colour_, &depth_);
  if (samples > 1) {
    resolved_colour_ = renderbuffer(gl, GL_RGBA8, size, 1);
    resolved_framebuffer_ = framebuffer(gl, resolved_colour_, nullptr);
  }
}

void PictureTarget::bind() const {
  gl_->bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->viewport(0, 0, size_.width, size_.height);
}

Image PictureTarget::read(int channels) const {
  gl_->bind_framebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  if (samples_ > 1) {
    gl_->bind_framebuffer(GL_DRAW_FRAMEBUFFER, resolved_framebuffer_.name());
    gl_->blit_framebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_->bind_framebuffer(GL_READ_FRAMEBUFFER, resolved_framebuffer_.name());
  }
  Image image = Image::blank(size_, channels);
  gl_->pixel_store(GL_PACK_ALIGNMENT, 1);
  gl_->read_pixels(0, 0, size_.width, size_.height, channels == 4 ? GL_RGBA : GL_RGB, GL_UNSIGNED_BYTE,
                   image.pixels.data());
  check_gl(*gl_, "drawing a picture");
  if (channels == 4) straighten_alpha(image);
  return image;
}

ShadowMap::ShadowMap(const Gl& gl, int size)
    : gl_(&gl), size_(size), texture_(make_texture(gl)), framebuffer_(make_framebuffer(gl)) {
  check_side(gl, size, "a shadow map");
  gl.bind_texture(GL_TEXTURE_2D, texture_.name());
  gl.texture_image(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                   nullptr);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  const std::array<float, 4> lit{1.0F, 1.0F, 1.0F, 1.0F};
  gl.texture_parameters(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit.data());
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.framebuffer_texture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_.name(), 0);
  gl.draw_buffer(GL_NONE);
  gl.read_buffer(GL_NONE);
  check_framebuffer(gl);
  check_gl(gl, "making a shadow map");
}

void ShadowMap::bind() const {
  gl_->bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->viewport(0, 0, size_, size_);
}

void ShadowMap::bind_for_reading() const {
  gl_->active_texture(GL_TEXTURE0);
  gl_->bind_texture(GL_TEXTURE_2D, texture_.name());
}

}  // namespace taut
