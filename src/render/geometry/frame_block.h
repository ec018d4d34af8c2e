#pragma once

#include <glm/glm.hpp>

#include "base/image.h"
#include "geometry/geometry.h"
#include "render/camera.h"
#include "view/view.h"

namespace taut {

/// The uniform block Frame of shaders/frame.glsl, in its std140 layout. Meanings and units are given there;
/// all places are in picture space.
struct FrameBlock {
  glm::mat4 view_projection{1.0F}, shadow_matrix{1.0F};
  glm::vec4 eye{0.0F}, forward{0.0F}, fog{0.0F}, shadow{0.0F}, view{0.0F};
};

/// Distance between the grid lines of a ground (m).
double grid_spacing(const CameraPose& pose);

/// Height (m) of a pixel that is one metre away from the eye, along the line of sight.
float pixel_height(const CameraPose& pose, Size size);

/// From the eye to what it looks at (m).
float reach_of(const CameraPose& pose);

/// Nothing nearer to the eye than this is drawn (m).
float near_distance(const CameraPose& pose);

/// What the camera's pass needs, without shadows. `shift` moves the picture by a part of a pixel.
FrameBlock camera_block(const Geometry& geometry, Size size, const glm::vec2& shift = glm::vec2(0.0F));

/// What the shadow map's pass needs: the scene as seen from far away towards the light, a map of `map_size`²
/// texels around its bounds. Texels keep to the geometry's anchor, so that edges of shadows stay still while
/// the eye moves.
FrameBlock light_block(const Geometry& geometry, int map_size);

/// Texels of a depth map that one of the mask of a ground stands for, each way.
inline constexpr int mask_span = 4;

/// How high above a ground (m) things still hide the sky from it.
float contact_height(const CameraPose& pose);

/// How far (m) things hide light from all around from bodies and solids.
float shade_reach(const CameraPose& pose);

/// What a pass needs that shows a ground from below, as far as it is hidden from the sky: a map of
/// `map_size`² texels around all that is near it, its coordinates along the ground's axes, depth 0 as far
/// below the ground as 1 is above.
FrameBlock contact_block(const Geometry& geometry, const GroundPatch& ground, int map_size);

/// From clip space to a map's coordinates and depth, all 0 to 1.
glm::mat4 to_unit();

/// Lets the camera's pass read the map that was drawn with `light`.
void add_shadow(FrameBlock& camera, const FrameBlock& light);

}  // namespace taut
