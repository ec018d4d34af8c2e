#pragma once

#include "geometry/ground_patch.h"
#include "gl/program.h"

namespace taut {

/// What shaders/ground.vert is told of a ground, by the program that is in use.
inline void set_patch(const Program& program, const GroundPatch& patch) {
  program.set("normal", patch.normal);
  program.set("along", patch.along);
  program.set("across", patch.across);
  program.set("foot_and_height", glm::vec3(patch.foot, patch.height));
}

}  // namespace taut
