#pragma once

#include <memory>

#include "base/vectors.h"

namespace taut {

class SolidMesh;  // model/solid_mesh.h

/// A solid as it is read from a file and placed in a scene: what is at p in the mesh is at middle + p.
struct SolidData {
  std::shared_ptr<const SolidMesh> mesh;
  Vec3 middle = Vec3::Zero();  ///< m, of the box around it
};

}  // namespace taut
