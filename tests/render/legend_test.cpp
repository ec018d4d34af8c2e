#include "legend.h"

#include <gtest/gtest.h>

#include "render/text.h"
#include "small_scenes.h"

namespace taut {
namespace {

TEST(Legend, APixelOfItsBarHasTheColourOfItsValue) {
  const Font font = Font::load();
  for (const Theme theme : {Theme::light, Theme::dark})
    for (const Size picture : {Size{160, 90}, Size{320, 180}, Size{384, 216}, Size{641, 359}, Size{1280, 720},
                               Size{360, 1280}, Size{3840, 2160}}) {
      Image image = Image::blank(picture, 3);
      std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{120});
      const ColourScale scale{0.05, theme};
      const LegendBar bar = draw_legend(image, font, ColourBy::strain, scale);
      ASSERT_GE(bar.left, 0);
      ASSERT_LE(bar.top + bar.height, picture.height);
      int wrong = 0;
      for (int x = 0; x < bar.width; ++x) {
        const Rgba colour = opaque(scale.at((x + 0.5) / bar.width * scale.top));
        for (int y = bar.top; y < bar.top + bar.height; ++y)
          for (int channel = 0; channel < 3; ++channel) {
            const int there = testing::channel_at(image, bar.left + x, y, channel);
            wrong += std::abs(there - colour.at(static_cast<std::size_t>(channel))) > 1 ? 1 : 0;
          }
      }
      EXPECT_EQ(wrong, 0) << picture.width << "x" << picture.height;
    }
}

}  // namespace
}  // namespace taut
