#pragma once

#include "base/image.h"
#include "geometry/geometry.h"

namespace taut {

/// A rectangle of a picture's pixels.
struct Region {
  int left = 0, top = 0, width = 0, height = 0;

  bool empty() const { return width <= 0 || height <= 0; }
};

/// The smallest region that holds both.
Region around(const Region& a, const Region& b);

/// Where in a picture of that size something is drawn of all but the grounds: nothing outside is.
Region drawn_region(const Geometry& geometry, Size size);

/// Where in a picture of that size a ground is in shade, of the light or of the sky; the sharpest edges of
/// shadows are `blur` (m) wide.
Region shadow_region(const Geometry& geometry, const GroundPatch& ground, Size size, float blur);

/// Whether a ground may hide a part of what is drawn.
bool may_hide(const GroundPatch& ground, const Geometry& geometry);

}  // namespace taut
