#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/image.h"
#include "geometry/colour_scale.h"
#include "geometry/region.h"
#include "render/layers.h"
#include "render/text.h"
#include "view/view.h"

namespace taut {

/// A part of a picture, cut out: RGBA of the region's size, colour multiplied by alpha. Of several, their
/// mean.
struct Layer {
  Region region;
  std::vector<Image> passes;
};

/// What the colours mean.
struct Legend {
  Font font;
  ColourBy by = ColourBy::plain;
  ColourScale scale;
};

struct Layers {
  Size size;
  std::shared_ptr<const Image> backdrop;  ///< RGB; absent where the picture is transparent
  std::vector<Layer> parts;               ///< from back to front, inside the picture
  std::optional<Legend> legend;
  int bits = 8;  ///< of a sample of all of them
};

/// Lays a cut-out (RGBA, colour multiplied by alpha) over an opaque picture (RGB) of as many bits, its top
/// left corner at a pixel. It must lie inside.
void lay_over(Image& picture, int left, int top, const Image& cut_out);

}  // namespace taut
