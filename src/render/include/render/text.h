#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "base/image.h"
#include "render/overlay.h"

namespace taut {

/// A typeface to draw text into pictures with.
class Font {
 public:
  /// Reads a TrueType file; with an empty path, DejaVu Sans from where systems keep it. Throws RunFailure
  /// when there is none or it can't be read.
  static Font load(const std::filesystem::path& file = {});

  /// Width of a line of UTF-8 text (pixels) at a size (pixels from the top of an A's accent to a g's foot).
  double width(std::string_view text, double size) const;

  /// How far a capital letter rises above the baseline (pixels) at a size.
  double capital_height(double size) const;

  /// Draws a line of UTF-8 text, its left end on the baseline at a point.
  void draw(Image& image, const Point& baseline, std::string_view text, double size,
            const Paint& paint) const;

 private:
  struct Face;
  explicit Font(std::shared_ptr<const Face> face) : face_(std::move(face)) {}

  std::shared_ptr<const Face> face_;
};

}  // namespace taut
