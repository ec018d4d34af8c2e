#include "ground_shades.h"

#include <fmt/format.h>

#include "patch_uniforms.h"

namespace taut {
namespace {

Defines mask_defines() {
  return {fmt::format("SPAN {}", mask_span)};
}
Defines mask_defines(const char* also) {
  return {fmt::format("SPAN {}", mask_span), also};
}

}  // namespace

GroundShades::GroundShades(const Gl& gl, const ShaderLibrary& library, int map_size)
    : gl_(&gl),
      light_mask_program_(gl, library, "whole.vert", "ground_mask.frag", mask_defines()),
      sky_mask_program_(gl, library, "whole.vert", "ground_mask.frag", mask_defines("FADING")),
      plain_(gl, library, "ground.vert", "ground_shade.frag"),
      with_contact_(gl, library, "ground.vert", "ground_shade.frag", {"CONTACT"}),
      no_attributes_(make_vertex_array(gl)),
      contact_map_(gl, map_size / 2),
      light_mask_(gl, map_size / mask_span),
      sky_mask_(gl, map_size / 2 / mask_span) {}

void GroundShades::draw(const Geometry& geometry, std::size_t ground, const Region& part, Size picture,
                        const FrameBlock& camera, const ShadowMap& light,
                        const std::optional<FrameBlock>& contact) {
  const GroundPatch& patch = geometry.grounds[ground];
  gl_->bind_vertex_array(no_attributes_.name());
  const GroundMask of_light = mask_of_light(geometry, patch, camera, light_mask_.size());
  draw_mask(light_mask_program_, light_mask_, light, of_light);
  light.bind_for_reading();
  GroundMask of_sky;
  if (contact) {
    of_sky = mask_of_sky(geometry, patch, *contact, sky_mask_.size());
    draw_mask(sky_mask_program_, sky_mask_, contact_map_, of_sky);
  }

  while (shades_.size() <= ground) shades_.push_back({LightMap(*gl_)});
  Shade& shade = shades_[ground];
  const Reduced where = reduced(part, picture);
  shade.map.begin(where.part, where.corner, where.picture);
  // Beside the ground's edge there is light.
  gl_->clear_colour(1.0F, 1.0F, 1.0F, 1.0F);
  gl_->clear(GL_COLOR_BUFFER_BIT);
  shade.scale = where.scale * shade.map.texel();
  shade.start = where.start * shade.map.texel();
  shade.last = (glm::vec2(where.part.width, where.part.height) - 0.5F) * shade.map.texel();
  const Program& program = contact ? with_contact_ : plain_;
  program.use();
  set_patch(program, patch);
  program.set("light_mask", 3);
  program.set("light_reach", of_light.reach);
  light_mask_.bind_for_reading(GL_TEXTURE3);
  if (contact) {
    program.set("sky_mask", 4);
    program.set("sky_reach", of_sky.reach);
    program.set("sky_place", of_sky.place);
    sky_mask_.bind_for_reading(GL_TEXTURE4);
  }
  gl_->bind_vertex_array(no_attributes_.name());
  gl_->draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
}

void GroundShades::bind(const Program& program, std::size_t ground) const {
  const Shade& shade = shades_[ground];
  shade.map.bind_for_reading();
  program.set("shade_scale", glm::vec3(shade.scale, 0.0F));
  program.set("shade_start", glm::vec3(shade.start, 0.0F));
  program.set("shade_last", glm::vec3(shade.last, 0.0F));
}

void GroundShades::draw_mask(const Program& program, const MaskMap& mask, const ShadowMap& depths,
                             const GroundMask& how) {
  mask.begin(how.corner, how.part);
  program.use();
  program.set("depths", 2);
  program.set("plane", how.plane);
  program.set("range", how.range);
  depths.bind_for_depths();
  gl_->draw_arrays(GL_TRIANGLES, 0, 3);
  mask.end(2.0F * how.reach.x);
}

}  // namespace taut
