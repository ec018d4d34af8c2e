#pragma once

#include "geometry/bodies.h"
#include "geometry/picture_space.h"
#include "model/colliders.h"
#include "view/view.h"

namespace taut {

/// Adds marks to a round solid that turns, by which it is seen to: stripes along a capsule, spots around a
/// ball. Nothing for others.
void add_turning_marks(Bodies& bodies, const Collider& collider, double time, const PictureSpace& space,
                       const Colour& colour);

}  // namespace taut
