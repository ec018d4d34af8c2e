#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/bodies.h"
#include "geometry/ground_patch.h"
#include "view/view.h"

namespace taut {

/// Whether a look shows what keeps light from all around from bodies and solids: where colours mean something
/// they stay what they are.
inline bool shows_contact(const Look& look) {
  return look.shadows && look.colour_by == ColourBy::plain;
}

/// Works out how much light from all around reaches bodies and solids past what is within `reach` (m): one
/// another, and grounds. It goes into tiles of Bodies::shades, where records and shaders find it; what has
/// nothing near it gets none.
void add_contact_shades(Bodies& bodies, const std::vector<GroundPatch>& grounds, float reach);

}  // namespace taut
