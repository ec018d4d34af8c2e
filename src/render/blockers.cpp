#include "blockers.h"

#include <fmt/format.h>

#include <algorithm>

namespace taut {
namespace {

// How much more what is at a map's near end counts than what is at its far one: e to the power of this.
constexpr int nearer = 80;
// Texels of the shadow map that a texel stands for, each way. It sees as many more on each side, so that it
// sees as far as penumbras reach.
int span_of(int map_size) {
  constexpr int least = 8, texels = 128;
  return std::max(least, map_size / texels);
}

}  // namespace

Blockers::Blockers(const Gl& gl, const ShaderLibrary& library, int map_size)
    : gl_(&gl),
      side_(std::max(map_size / span_of(map_size), 1)),
      program_(gl, library, "whole.vert", "blockers.frag",
               {fmt::format("SPAN {}", span_of(map_size)), fmt::format("NEARER {}.0", nearer)}),
      no_attributes_(make_vertex_array(gl)),
      texture_(make_texture(gl)),
      framebuffer_(make_framebuffer(gl)) {
  gl.active_texture(GL_TEXTURE5);
  gl.bind_texture(GL_TEXTURE_2D, texture_.name());
  gl.texture_image(GL_TEXTURE_2D, 0, GL_R32F, side_, side_, 0, GL_RED, GL_FLOAT, nullptr);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.framebuffer_texture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  check_gl(gl, "making a map of what throws shadows");
}

void Blockers::draw(const ShadowMap& map) {
  gl_->bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->viewport(0, 0, side_, side_);
  program_.use();
  program_.set("depths", 2);
  map.bind_for_depths();
  gl_->bind_vertex_array(no_attributes_.name());
  gl_->draw_arrays(GL_TRIANGLES, 0, 3);
  gl_->active_texture(GL_TEXTURE5);
  gl_->bind_texture(GL_TEXTURE_2D, texture_.name());
  map.bind_for_reading();
}

}  // namespace taut
