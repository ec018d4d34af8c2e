#include "geometry/ground_patch.h"

#include <cmath>

#include "geometry/view_matrices.h"

namespace taut {

GroundPatch ground_patch(const Ground& ground, const PictureSpace& space, double period) {
  const Vec3 normal = space.direction(ground.normal);
  const Eigen::Matrix3d axes = upright_axes(normal);
  const Vec3 origin = space.place(Vec3::Zero());
  GroundPatch patch;
  patch.normal = to_glm(normal);
  patch.along = to_glm(axes.col(0));
  patch.across = to_glm(axes.col(2));
  patch.height = static_cast<float>(-normal.dot(space.place(ground.point)));
  // Only what is left of whole periods: far from the origin single precision has no digits for the rest.
  patch.foot = {static_cast<float>(std::fmod(-axes.col(0).dot(origin), period)),
                static_cast<float>(std::fmod(-axes.col(2).dot(origin), period))};
  patch.solid = ground.solid;
  patch.colour = ground.colour;
  return patch;
}

}  // namespace taut
