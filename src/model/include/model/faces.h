#pragma once

#include "base/vectors.h"
#include "model/colliders.h"

namespace taut {

/// A sheet whose faces touch: no solid comes nearer to its triangles than half a thickness, no other face
/// than the half thicknesses of both.
struct SheetFaces {
  Index sheet = 0;            ///< in Model::sheets
  double thickness = 0.0;     ///< m
  double friction = 0.5;      ///< Coulomb's coefficient, of faces on faces; of two sheets the geometric mean
  bool self_collides = true;  ///< whether its faces touch one another
  Index body = no_body;       ///< touch those of other bodies; no_body: of none
};

}  // namespace taut
