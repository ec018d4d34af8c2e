#pragma once

#include <glm/glm.hpp>

#include "base/image.h"
#include "geometry/picture_space.h"
#include "render/camera.h"

namespace taut {

inline glm::vec3 to_glm(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Picture space, where the eye is the origin, to camera space: x to the right, y to the picture's top, −z
/// along the line of sight.
glm::mat4 view_matrix(const CameraPose& pose, const PictureSpace& space);

/// Camera to clip space, upside down: OpenGL's first row is then the picture's top one.
glm::mat4 flipped_projection(const CameraPose& pose, Size size, float near, float far);

}  // namespace taut
