#pragma once

#include "gl/program.h"
#include "gl/targets.h"

namespace taut {

/// What a shadow map holds around each place, from which shaders/soft_shadow.glsl finds how far off that is
/// what throws a shadow.
class Blockers {
 public:
  /// `map_size`: of the shadow map that will be read.
  Blockers(const Gl& gl, const ShaderLibrary& library, int map_size);

  /// Works that out, and lets shaders read both.
  void draw(const ShadowMap& map);

 private:
  const Gl* gl_;
  int side_;
  Program program_;
  GlObject no_attributes_, texture_, framebuffer_;
};

}  // namespace taut
