#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "frames/captions.h"
#include "frames/panels.h"
#include "frames/simulation.h"
#include "output/plot_colour.h"
#include "panel_runs.h"
#include "scenes_of_the_program.h"

namespace taut {
namespace {

constexpr Size picture{640, 360};

Image grey(Size size) {
  Image image = Image::blank(size, 3);
  std::ranges::fill(image.pixels, std::uint8_t{128});
  return image;
}

std::array<int, 3> pixel(const Image& image, int x, int y) {
  const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) +
                              static_cast<std::size_t>(x));
  return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
}

std::string hexadecimal(const std::array<int, 3>& rgb) {
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

Image captioned(Theme theme, const Caption& caption, Size size = picture) {
  const CaptionWriter writer(theme);
  const Size drawn{size.width, size.height - caption_height(size)};
  const std::array<Image, 1> pictures{grey(drawn)};
  const std::array<Caption, 1> captions{caption};
  return laid_out({size, 1, 1}, pictures, captions, &writer, theme);
}

// The greatest contrast to the plate in some rows: that of the ink itself.
double ink_contrast(const Image& image, int from, int to) {
  const std::array<int, 3> plate = pixel(image, 1, image.size.height - 2);
  double most = 1.0;
  for (int y = from; y < to; ++y)
    for (int x = 0; x < image.size.width; ++x)
      if (const std::array<int, 3> here = pixel(image, x, y); here != plate)
        most = std::max(most, contrast_ratio(hexadecimal(plate), hexadecimal(here)));
  return most;
}

TEST(Captions, LieBelowThePictureAndNotOnIt) {
  const Image image = captioned(Theme::light, {"Title", "1.00 s", "a line", false});
  ASSERT_EQ(image.size.height, picture.height);
  const int drawn = picture.height - caption_height(picture);
  for (int y = 0; y < drawn; ++y)
    for (int x = 0; x < picture.width; ++x) ASSERT_EQ(pixel(image, x, y), (std::array{128, 128, 128}));
  EXPECT_GT(ink_contrast(image, drawn, picture.height), 4.5);
}

TEST(Captions, CanBeReadInEitherTheme) {
  const Size large{1920, 1080};
  const int drawn = large.height - caption_height(large), middle = drawn + caption_height(large) * 3 / 5;
  for (const Theme theme : {Theme::light, Theme::dark})
    for (const bool failed : {false, true}) {
      const Image image = captioned(theme, {"HHHH", "1 s", "HHHH", failed}, large);
      EXPECT_GT(ink_contrast(image, drawn, middle), 4.5);
      EXPECT_GT(ink_contrast(image, middle, large.height), 4.5);
    }
}

TEST(Captions, EndWithinThePicture) {
  const std::string endless(400, 'W');
  for (const Size size : {Size{160, 90}, Size{640, 360}, Size{360, 640}}) {
    const Image image = captioned(Theme::light, {endless, "12.34 s", endless, false}, size);
    const std::array<int, 3> plate = pixel(image, 0, size.height - 1);
    for (int y = size.height - caption_height(size); y < size.height; ++y) {
      EXPECT_EQ(pixel(image, size.width - 1, y), plate);
      EXPECT_EQ(pixel(image, 0, y), plate);
    }
  }
}

TEST(Captions, PlacesWithoutAPictureHaveTheColourOfThePlate) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const CaptionWriter writer(theme);
    const SheetGrid grid = sheet_grid({64, 48}, 5);
    const std::vector<Image> pictures(5, grey({64, 48 - caption_height({64, 48})}));
    const Image sheet = laid_out(grid, pictures, std::vector<Caption>(5), &writer, theme);
    EXPECT_EQ(pixel(sheet, 3 * 64 - 20, 2 * 48 - 20), pixel(sheet, 10, 44));
  }
}

TEST(Captions, GiveErrorsASignOnlyWhereTheyHaveDigits) {
  Scene scene = test::scene_called("pendulum");
  RunMeasures measures;
  measures.energy_error = -1e-9;
  EXPECT_NE(panel_caption(scene, measures, "1.00 s", {}, false).line.find("energy error below 0.0001 %"),
            std::string::npos);
  measures.energy_error = -0.0123;
  EXPECT_NE(panel_caption(scene, measures, "1.00 s", {}, false).line.find("energy −1.2 %"),
            std::string::npos);
  measures.energy_error = 0.0123;
  const Caption alone = panel_caption(scene, measures, "1.00 s", {}, true);
  EXPECT_NE(alone.line.find("energy +1.2 %"), std::string::npos);
  EXPECT_EQ(alone.title, scene.title);
  EXPECT_EQ(alone.time, "1.00 s");
  EXPECT_TRUE(panel_caption(scene, measures, "1.00 s", "a reason", false).failed);
  scene.look.speed = {{0.5, 0.2}};
  EXPECT_EQ(film_time_text(scene, 1.0), "1.00 s, 5 × slower");
  EXPECT_EQ(time_text(scene, 1.0), "1.00 s") << "no picture is slow";
}

}  // namespace
}  // namespace taut
