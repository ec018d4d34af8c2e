#pragma once

#include <glm/glm.hpp>

#include "base/image.h"
#include "model/state.h"
#include "picture_space.h"
#include "render/camera.h"
#include "view/view.h"

namespace taut {

/// The uniform block Frame of shaders/frame.glsl, in its std140 layout. Meanings and units are given there;
/// all places are in picture space.
struct FrameBlock {
  glm::mat4 view_projection{1.0F}, shadow_matrix{1.0F};
  glm::vec4 eye{0.0F}, forward{0.0F}, to_light{0.0F}, light{0.0F};
  glm::vec4 ambient_below{0.0F}, ambient_above{0.0F}, horizon{0.0F}, sky{0.0F};
  glm::vec4 ground{0.0F}, fog{0.0F}, shadow{0.0F}, view{0.0F};
};

/// An axis-parallel box (m).
struct Bounds {
  glm::vec3 low{0.0F}, high{0.0F};
};

/// The box around all masses of a state in picture space, `margin` (m) wider on every side.
Bounds bounds_of(const State& state, double margin);

/// What the camera's pass needs, without shadows.
FrameBlock camera_block(const CameraPose& pose, const PictureSpace& space, Size size, int samples,
                        const Bounds& bounds, const Look& look);

/// What the shadow map's pass needs: the scene as seen from far away towards the light, a map of `map_size`²
/// texels around the box. Texels keep to a place (in picture space), so that edges of shadows stay still
/// while the eye moves, as long as that place stays where it is in the world.
FrameBlock light_block(const Bounds& bounds, int map_size, const Vec3& place);

/// Lets the camera's pass read the map that was drawn with `light`.
void add_shadow(FrameBlock& camera, const FrameBlock& light);

}  // namespace taut
