#pragma once

#include "base/image.h"
#include "geometry/colour_scale.h"
#include "render/text.h"
#include "view/view.h"

namespace taut {

/// Where the colours of a legend are, in whole pixels.
struct LegendBar {
  int left = 0, top = 0, width = 0, height = 0;
};

/// Draws what the colours mean into the picture's lower left corner: the quantity, its scale, numbers and
/// unit. Column i of the bar has the colour of the value (i + ½) / width of the scale's top.
LegendBar draw_legend(Image& image, const Font& font, ColourBy by, const ColourScale& scale);

}  // namespace taut
