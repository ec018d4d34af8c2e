#pragma once

#include <deque>
#include <optional>

#include "geometry/ground_shade.h"
#include "gl/program.h"
#include "gl/targets.h"

namespace taut {

/// Works out how much light and sky reaches the grounds of a picture, into a map of a texel for two pixels
/// each way: shades have soft edges, and what makes them soft costs more than one look-up.
class GroundShades {
 public:
  /// `map_size`: of the shadow map that will be read.
  GroundShades(const Gl& gl, const ShaderLibrary& library, int map_size);

  /// Where to draw, with contact_block(), what may hide the sky from a ground.
  const ShadowMap& contact_map() const { return contact_map_; }

  /// Works out a part of the picture of a ground, of those of the geometry, with the camera's block loaded.
  /// `contact` has been drawn into the contact map, if it is there.
  void draw(const Geometry& geometry, std::size_t ground, const Region& part, Size picture,
            const FrameBlock& camera, const ShadowMap& light, const std::optional<FrameBlock>& contact);

  /// Lets shaders/ground.frag, which is in use, read what was worked out for a ground.
  void bind(const Program& program, std::size_t ground) const;

 private:
  struct Shade {
    LightMap map;
    glm::vec2 scale{0.0F}, start{0.0F}, last{0.0F};  // from pixels of the part to its coordinates
  };

  void draw_mask(const Program& program, const MaskMap& mask, const ShadowMap& depths, const GroundMask& how);

  const Gl* gl_;
  Program light_mask_program_, sky_mask_program_;
  Program plain_, with_contact_;
  GlObject no_attributes_;
  ShadowMap contact_map_;
  MaskMap light_mask_, sky_mask_;
  std::deque<Shade> shades_;  // one a ground
};

}  // namespace taut
