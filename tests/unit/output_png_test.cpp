#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>

#include "output/atomic_file.h"
#include "output/png.h"
#include "output/png_check.h"
#include "temporary_folder.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>

namespace taut {
namespace {

// Smooth in one half and noise in the other: the compressor finds matches here and none there.
Image test_image(Size size, int channels) {
  Image image = Image::blank(size, channels);
  std::mt19937 random(7);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(i < image.pixels.size() / 2 ? i / 64 : random());
  return image;
}

class PngTest : public ::testing::TestWithParam<std::tuple<int, int, int>> {};

TEST_P(PngTest, AnotherDecoderFindsTheSamePixels) {
  const auto [width, height, channels] = GetParam();
  const Image image = test_image({width, height}, channels);
  const std::vector<std::uint8_t> png = encode_png(image);
  int read_width = 0, read_height = 0, read_channels = 0;
  stbi_uc* pixels = stbi_load_from_memory(png.data(), static_cast<int>(png.size()), &read_width, &read_height,
                                          &read_channels, 0);
  ASSERT_NE(pixels, nullptr) << stbi_failure_reason();
  EXPECT_EQ(read_width, width);
  EXPECT_EQ(read_height, height);
  EXPECT_EQ(read_channels, channels);
  EXPECT_TRUE(std::equal(image.pixels.begin(), image.pixels.end(), pixels));
  stbi_image_free(pixels);
}

INSTANTIATE_TEST_SUITE_P(Sizes, PngTest,
                         ::testing::Combine(::testing::Values(1, 17, 640), ::testing::Values(1, 19, 480),
                                            ::testing::Values(3, 4)));

TEST(WholePng, IsToldFromACutOneAndFromOneOfAnotherSize) {
  const testing::TemporaryFolder folder;
  const std::vector<std::uint8_t> png = encode_png(test_image({40, 30}, 3));
  const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
  write_file(folder / "whole.png", bytes);
  write_file(folder / "cut.png", bytes.substr(0, bytes.size() - 5));
  EXPECT_TRUE(is_whole_png(folder / "whole.png", {40, 30}));
  EXPECT_FALSE(is_whole_png(folder / "whole.png", {30, 40}));
  EXPECT_FALSE(is_whole_png(folder / "cut.png", {40, 30}));
  EXPECT_FALSE(is_whole_png(folder / "none.png", {40, 30}));
}

}  // namespace
}  // namespace taut
