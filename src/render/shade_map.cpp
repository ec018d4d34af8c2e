#include "shade_map.h"

namespace taut {

ShadeMap::ShadeMap(const Gl& gl)
    : gl_(&gl), textures_{make_texture(gl), make_texture(gl), make_texture(gl)} {}

void ShadeMap::upload(const ShadeTiles& tiles) {
  gl_->active_texture(GL_TEXTURE6);
  gl_->bind_texture(GL_TEXTURE_2D, textures_.at(turn_++ % textures_.size()).name());
  gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_->texture_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_->texture_image(GL_TEXTURE_2D, 0, GL_R8, ShadeTiles::width,
                     static_cast<GLsizei>(tiles.texels.size() / ShadeTiles::width), 0, GL_RED,
                     GL_UNSIGNED_BYTE, tiles.texels.data());
}

}  // namespace taut
