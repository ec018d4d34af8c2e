#pragma once

#include "model/description.h"

namespace taut::test {

/// A ball of half a metre that flies along x at 1 m/s without gravity, through the origin after two seconds,
/// and throws off what it meets with 0.6 of the speed at which they met.
inline Description flying_bat() {
  Description description;
  description.gravity = Vec3::Zero();
  SphereSpec bat;
  bat.centre = {-2, 0, 0};
  bat.radius = 0.5;
  bat.restitution = 0.6;
  bat.moves.motion.path = {{0, {-2, 0, 0}}, {1, {-1, 0, 0}}, {2, {0, 0, 0}}, {3, {1, 0, 0}}, {4, {2, 0, 0}}};
  description.spheres = {bat};
  return description;
}

}  // namespace taut::test
