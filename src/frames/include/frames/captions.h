#pragma once

#include <string>

#include "base/image.h"
#include "render/overlay.h"
#include "render/text.h"
#include "view/view.h"

namespace taut {

/// What is said of one picture, in two rows below it.
struct Caption {
  std::string title, time;  ///< at the left and right end of the upper row
  std::string line;         ///< the lower row, smaller
  bool failed = false;      ///< the line says how: in a warning colour
};

/// Rows (pixels) that the caption of a picture takes of its size.
int caption_height(Size picture);

/// Writes captions below pictures, on a plate in the colours of a theme. Text that is too long for its place
/// becomes smaller, and then ends in an ellipsis.
class CaptionWriter {
 public:
  /// Throws RunFailure when there is no font.
  explicit CaptionWriter(Theme theme) : theme_(theme), font_(Font::load()) {}

  /// Fills a part of a sheet with the colour of the plate.
  void fill(Image& sheet, const Rectangle& area) const;
  /// Writes on the plate `band`, below a picture whose size, with it, is `picture`.
  void write(Image& sheet, const Rectangle& band, Size picture, const Caption& caption) const;

 private:
  Theme theme_;
  Font font_;
};

}  // namespace taut
