#pragma once

#include "base/image.h"
#include "geometry/colour_scale.h"
#include "render/text.h"
#include "view/view.h"

namespace taut {

/// Draws what the colours mean into the picture's lower left corner: the quantity, its scale, numbers and
/// unit.
void draw_legend(Image& image, const Font& font, ColourBy by, const ColourScale& scale);

}  // namespace taut
