#pragma once

#include <array>

#include "geometry/shade_tiles.h"
#include "gl/gl_objects.h"

namespace taut {

/// The tiles of how much light from all around reaches bodies and solids, as shaders/shade.glsl reads them.
class ShadeMap {
 public:
  explicit ShadeMap(const Gl& gl);

  void upload(const ShadeTiles& tiles);

 private:
  const Gl* gl_;
  std::array<GlObject, 3> textures_;  // taken in turn: the last may still be read from
  std::size_t turn_ = 0;
};

}  // namespace taut
