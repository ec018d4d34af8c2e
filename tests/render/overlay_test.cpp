#include "render/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/failure.h"
#include "render/text.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::channel_at;

constexpr Paint white{{1.0, 1.0, 1.0}, 1.0};

TEST(Overlay, RectangleCoversWholeAndHalfPixels) {
  Image image = Image::blank({6, 4}, 3);
  fill_rectangle(image, {1.0, 1.0, 2.5, 2.0}, white);
  EXPECT_EQ(0, channel_at(image, 0, 1, 0));
  EXPECT_EQ(255, channel_at(image, 1, 1, 0));
  EXPECT_EQ(255, channel_at(image, 2, 2, 0));
  EXPECT_EQ(128, channel_at(image, 3, 1, 0));
  EXPECT_EQ(0, channel_at(image, 4, 1, 0));
  EXPECT_EQ(0, channel_at(image, 1, 3, 0));
}

TEST(Overlay, RectangleReachingOutsideIsCutOff) {
  Image image = Image::blank({4, 4}, 3);
  fill_rectangle(image, {-10.0, -10.0, 100.0, 100.0}, white);
  EXPECT_EQ(255, *std::min_element(image.pixels.begin(), image.pixels.end()));
}

TEST(Overlay, PaintMixesWithWhatIsThere) {
  Image image = Image::blank({1, 1}, 3);
  image.pixels = {200, 100, 0};
  blend_pixel(image, 0, 0, {{0.0, 0.0, 1.0}, 0.25});
  EXPECT_EQ((std::vector<std::uint8_t>{150, 75, 64}), image.pixels);
}

TEST(Overlay, PaintOnNothingKeepsItsColour) {
  Image image = Image::blank({1, 1}, 4);
  blend_pixel(image, 0, 0, {{1.0, 0.0, 0.0}, 0.5});
  EXPECT_EQ((std::vector<std::uint8_t>{255, 0, 0, 128}), image.pixels);
}

TEST(Overlay, LineIsAsWideAsAsked) {
  Image image = Image::blank({20, 20}, 3);
  draw_line(image, {2.0, 10.0}, {18.0, 10.0}, 4.0, white);
  int sum = 0;
  for (int y = 0; y < 20; ++y) sum += channel_at(image, 10, y, 0);
  EXPECT_NEAR(4.0, sum / 255.0, 0.05);
}

TEST(Overlay, InsetIsCutOffAtTheEdges) {
  Image image = Image::blank({4, 4}, 3);
  Image inset = Image::blank({3, 3}, 3);
  std::fill(inset.pixels.begin(), inset.pixels.end(), std::uint8_t{9});
  place_image(image, 2, -1, inset);
  EXPECT_EQ(9, channel_at(image, 2, 0, 0));
  EXPECT_EQ(9, channel_at(image, 3, 1, 2));
  EXPECT_EQ(0, channel_at(image, 1, 0, 0));
  EXPECT_EQ(0, channel_at(image, 2, 2, 0));
  place_image(image, 50, 50, inset);
  EXPECT_THROW(place_image(image, 0, 0, Image::blank({1, 1}, 4)), RunFailure);
}

TEST(Text, LongerTextIsWider) {
  const Font font = Font::load();
  EXPECT_GT(font.width("strain", 20.0), font.width("str", 20.0));
  EXPECT_NEAR(2.0 * font.width("strain", 20.0), font.width("strain", 40.0), 1e-3);
  EXPECT_DOUBLE_EQ(0.0, font.width("", 20.0));
}

TEST(Text, Utf8IsOneCharacterEach) {
  const Font font = Font::load();
  // Figures are all equally wide in this typeface, and so is the superscript with itself.
  EXPECT_NEAR(2.0 * font.width("²", 20.0), font.width("²²", 20.0), 1e-3);
  EXPECT_LT(font.width("²", 20.0), font.width("22", 20.0));
}

TEST(Text, StandsOnItsBaseline) {
  const Font font = Font::load();
  Image image = Image::blank({60, 60}, 3);
  font.draw(image, {10.0, 40.0}, "H", 40.0, white);
  int first = 60, last = -1;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      if (channel_at(image, x, y, 0) < 128) continue;
      first = std::min(first, y);
      last = std::max(last, y);
    }
  }
  EXPECT_EQ(39, last);
  EXPECT_NEAR(40.0 - font.capital_height(40.0), first, 1.0);
}

TEST(Text, FilesThatAreNoFontsAreRefused) {
  EXPECT_THROW(Font::load("/no/such/font.ttf"), RunFailure);
  EXPECT_THROW(Font::load(__FILE__), RunFailure);
}

}  // namespace
}  // namespace taut
