#pragma once

#include "geometry/bodies.h"
#include "geometry/body_parts.h"
#include "geometry/colour_scale.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// Adds ragdolls: a trunk, a neck and a head, limbs that taper, hands and feet. Where they meet their
/// surfaces are one, in one colour; coloured by limits, joints are balls that stand out. Sizes are within a
/// few hundredths of the height of what collides. Those that are not drawn as bodies are left out.
void add_figures(Bodies& bodies, const std::vector<BodyParts>& parts, const Drawn& drawn);

}  // namespace taut
