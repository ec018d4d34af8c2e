#include "gl/targets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
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

GLenum colour_format(int bits) {
  return bits == 16 ? GL_RGBA16 : GL_RGBA8;
}

// From the share of a pixel that isn't covered to that which is: all bits the other way, whatever their
// number.
void turn_alpha_round(Image& image) {
  const std::size_t bytes = image.bytes_of_pixel(), sample = bytes / 4;
  for (std::size_t pixel = 0; pixel < image.pixels.size(); pixel += bytes)
    for (std::size_t i = pixel + 3 * sample; i < pixel + bytes; ++i)
      image.pixels[i] = static_cast<std::uint8_t>(255 - image.pixels[i]);
}

// What the bound texture holds outside of itself, in all channels.
void surround(const Gl& gl, float value) {
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  const std::array<float, 4> outside{value, value, value, value};
  gl.texture_parameters(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, outside.data());
}

// Of averages, each over twice as many texels each way as the one before.
constexpr int mask_levels = 6;

int power_of_two_above(int side) {
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(side)));
}

// Targets change in steps of the tiles in which Mesa's software drivers draw, so that seldom one is made
// anew.
int rounded_up(int side, int most) {
  constexpr int step = 64;
  return std::min((side + step - 1) / step * step, most);
}

}  // namespace

int samples_at_once(const Gl& gl, int wanted) {
  const int most = limit(gl, GL_MAX_SAMPLES);
  if (wanted > most && wanted == 8 && most >= 4) return 4;
  if (wanted >= 1 && wanted <= most) return wanted;
  throw BadRequest(std::to_string(wanted) + " samples a pixel can't be drawn: at least 1, at most " +
                   std::to_string(most));
}

PictureTarget::PictureTarget(const Gl& gl, Size picture, int samples, int bits)
    : gl_(&gl), picture_(picture), samples_(samples), bits_(bits) {
  check_side(gl, picture.width, "a picture width");
  check_side(gl, picture.height, "a picture height");
}

void PictureTarget::make_room(Size size) {
  const Size wanted{rounded_up(size.width, picture_.width), rounded_up(size.height, picture_.height)};
  if (wanted.width == room_.width && wanted.height == room_.height) return;
  room_ = wanted;
  colour_ = renderbuffer(*gl_, colour_format(bits_), room_, samples_);
  depth_ = renderbuffer(*gl_, GL_DEPTH_COMPONENT24, room_, samples_);
  framebuffer_ = framebuffer(*gl_, colour_, &depth_);
}

void PictureTarget::begin(const Region& region, Alpha alpha) {
  make_room({region.width, region.height});
  region_ = region;
  alpha_ = alpha;
  gl_->bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->viewport(-region.left, -region.top, picture_.width, picture_.height);
  if (alpha == Alpha::share) {
    // Mesa's software drivers know nothing of GL_SAMPLE_ALPHA_TO_ONE. But blending can set alpha to 0, so
    // there it is the share that isn't covered.
    gl_->enable(GL_BLEND);
    gl_->blend_function(GL_ONE, GL_ZERO, GL_ZERO, GL_ZERO);
  }
  gl_->clear_colour(0.0F, 0.0F, 0.0F, alpha == Alpha::share ? 1.0F : 0.0F);
  gl_->clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Readback PictureTarget::end() {
  gl_->disable(GL_BLEND);
  return {*gl_, framebuffer_, {region_.width, region_.height}, alpha_, bits_};
}

Readback::Readback(const Gl& gl, const GlObject& from, Size size, Alpha alpha, int bits)
    : gl_(&gl),
      size_(size),
      alpha_(alpha),
      bits_(bits),
      colour_(renderbuffer(gl, colour_format(bits), size, 1)),
      framebuffer_(framebuffer(gl, colour_, nullptr)) {
  gl.bind_framebuffer(GL_READ_FRAMEBUFFER, from.name());
  gl.blit_framebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

Image Readback::fetch() const {
  gl_->bind_framebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  Image image = Image::blank(size_, 4, bits_);
  gl_->pixel_store(GL_PACK_ALIGNMENT, 1);
  gl_->read_pixels(0, 0, size_.width, size_.height, GL_RGBA,
                   bits_ == 16 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE, image.pixels.data());
  check_gl(*gl_, "drawing a picture");
  if (alpha_ == Alpha::share) turn_alpha_round(image);
  return image;
}

LightMap::LightMap(const Gl& gl) : gl_(&gl), texture_(make_texture(gl)), framebuffer_(make_framebuffer(gl)) {}

void LightMap::begin(Size size) {
  if (size.width > room_.width || size.height > room_.height) {
    // Powers of two: else coordinates would be rounded otherwise the larger it has grown, and pictures
    // differ by what was drawn before.
    room_ = {std::max(power_of_two_above(size.width), room_.width),
             std::max(power_of_two_above(size.height), room_.height)};
    bind_for_reading();
    gl_->texture_image(GL_TEXTURE_2D, 0, GL_RGBA8, room_.width, room_.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                       nullptr);
    gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_->bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_->framebuffer_texture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
    check_framebuffer(*gl_);
  }
  gl_->bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->viewport(0, 0, size.width, size.height);
}

void LightMap::begin(Size size, const glm::ivec2& corner, Size picture) {
  begin(size);
  gl_->viewport(-corner.x, -corner.y, picture.width, picture.height);
}

void LightMap::bind_for_reading() const {
  gl_->active_texture(GL_TEXTURE1);
  gl_->bind_texture(GL_TEXTURE_2D, texture_.name());
}

glm::vec2 LightMap::texel() const {
  return 1.0F / glm::vec2(room_.width, room_.height);
}

ShadowMap::ShadowMap(const Gl& gl, int size)
    : gl_(&gl), size_(size), texture_(make_texture(gl)), framebuffer_(make_framebuffer(gl)) {
  check_side(gl, size, "a shadow map");
  gl.bind_texture(GL_TEXTURE_2D, texture_.name());
  gl.texture_image(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size, size, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                   nullptr);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  surround(gl, 1.0F);  // lit
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
  gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
}

void ShadowMap::bind_for_depths() const {
  gl_->active_texture(GL_TEXTURE2);
  gl_->bind_texture(GL_TEXTURE_2D, texture_.name());
  gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
}

MaskMap::MaskMap(const Gl& gl, int size)
    : gl_(&gl), size_(size), texture_(make_texture(gl)), framebuffer_(make_framebuffer(gl)) {
  bind_for_reading(GL_TEXTURE2);
  for (int level = 0; level <= mask_levels; ++level) {
    const int side = std::max(size >> level, 1);
    gl.texture_image(GL_TEXTURE_2D, level, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  }
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, mask_levels);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  surround(gl, 0.0F);
  gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.framebuffer_texture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  check_framebuffer(gl);
  check_gl(gl, "making a mask of a ground");
}

void MaskMap::begin(const glm::ivec2& corner, const glm::ivec2& size) const {
  gl_->bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->viewport(0, 0, size_, size_);
  gl_->clear_colour(0.0F, 0.0F, 0.0F, 0.0F);
  gl_->clear(GL_COLOR_BUFFER_BIT);
  gl_->enable(GL_SCISSOR_TEST);
  gl_->scissor(corner.x, corner.y, size.x, size.y);
}

void MaskMap::end(float across) const {
  gl_->disable(GL_SCISSOR_TEST);
  bind_for_reading(GL_TEXTURE2);
  // Each level costs as much as a draw of its own.
  const auto levels = static_cast<int>(std::ceil(std::log2(std::max(across, 1.0F))));
  gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, std::min(levels, mask_levels));
  gl_->make_mipmap(GL_TEXTURE_2D);
}

void MaskMap::bind_for_reading(GLenum unit) const {
  gl_->active_texture(unit);
  gl_->bind_texture(GL_TEXTURE_2D, texture_.name());
}

}  // namespace taut
