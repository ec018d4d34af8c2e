#pragma once

#include <glm/glm.hpp>

#include "base/image.h"
#include "geometry/frame_block.h"
#include "geometry/geometry.h"
#include "geometry/region.h"

namespace taut {

/// What shaders/ground_mask.frag and ground_shade.frag are told of a depth map that shows what is in the way
/// between a ground and a light, or the sky; meanings are given there.
struct GroundMask {
  glm::vec3 plane, range;         ///< of ground_mask.frag
  glm::vec3 reach;                ///< of ground_shade.frag
  glm::vec3 place{0.0F};          ///< sky_place there
  glm::ivec2 corner{0}, part{0};  ///< texels of the mask that anything can be in
};

/// Of the shadow map that a camera's block reads, for a mask of `size`² texels.
GroundMask mask_of_light(const Geometry& geometry, const GroundPatch& ground, const FrameBlock& camera,
                         int size);

/// Of a map that was drawn with contact_block(), for a mask of `size`² texels.
GroundMask mask_of_sky(const Geometry& geometry, const GroundPatch& ground, const FrameBlock& contact,
                       int size);

/// Whether the light falls on a ground from above, so that shadows on it have an end.
bool takes_shadows(const GroundPatch& ground);

/// Whether anything is so near a ground that it hides the sky from it.
bool is_near(const GroundPatch& ground, const Geometry& geometry);

/// A part of a picture drawn smaller: a texel for two pixels each way.
struct Reduced {
  Size picture;       ///< texels of the whole
  glm::ivec2 corner;  ///< the part's first texel
  Size part;
  glm::vec2
      scale;  ///< from pixels, counted from the part's corner, to texels counted from `corner`: times this …
  glm::vec2 start;  ///< … plus this
};
Reduced reduced(const Region& part, Size picture);

}  // namespace taut
