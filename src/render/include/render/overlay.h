#pragma once

#include "base/image.h"
#include "view/view.h"

namespace taut {

/// A place in a picture, in pixels from its top left corner: the first pixel's centre is at (0.5, 0.5).
struct Point {
  double x = 0.0, y = 0.0;
};

/// Sides parallel to the picture's, in pixels; edges between pixels are smoothed.
struct Rectangle {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

/// What to draw with.
struct Paint {
  Colour colour{0.0, 0.0, 0.0};
  double alpha = 1.0;  ///< 0 to 1
};

/// Lays paint of the given share over one pixel; outside the picture nothing happens.
void blend_pixel(Image& image, int x, int y, const Paint& paint, double share = 1.0);

void fill_rectangle(Image& image, const Rectangle& rectangle, const Paint& paint);

/// A smooth line with round ends, `width` pixels wide.
void draw_line(Image& image, const Point& from, const Point& to, double width, const Paint& paint);

/// Copies a picture into another of the same channel count with its top left corner at a pixel; what lies
/// outside is cut off. Throws RunFailure when the channel counts differ.
void place_image(Image& image, int left, int top, const Image& inset);

}  // namespace taut
