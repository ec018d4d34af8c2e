#include <gtest/gtest.h>

#include "picture_behind.h"

namespace taut {
namespace {

// A row of six pixels, all of a grey.
Image grey_row(std::uint8_t level) {
  Image image = Image::blank({6, 1}, 3);
  std::ranges::fill(image.pixels, level);
  return image;
}

TEST(PictureBehind, LinesStandBehindWhatIsThere) {
  const Image backdrop = grey_row(220);
  Image lines = backdrop, picture = backdrop;
  for (std::size_t i = 3; i < 15; ++i) lines.pixels[i] = 40;     // pixels 1 to 4
  for (std::size_t i = 9; i < 18; ++i) picture.pixels[i] = 120;  // pixels 3 to 5
  picture.pixels[0] = 219;                                       // no more than noise
  const Image before = picture;
  show_behind(backdrop, lines, picture);
  EXPECT_EQ(picture.pixels[0], 220);
  for (std::size_t i = 3; i < 9; ++i) EXPECT_EQ(picture.pixels[i], 40) << "a line before the backdrop";
  for (std::size_t i = 9; i < 18; ++i) EXPECT_EQ(picture.pixels[i], before.pixels[i]) << "behind a thing";
}

}  // namespace
}  // namespace taut
