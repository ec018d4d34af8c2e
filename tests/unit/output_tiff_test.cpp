// Pictures of 16 bits a channel, in files and beneath legends.

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <string>

#include "base/failure.h"
#include "output/frame_file.h"
#include "output/tiff.h"
#include "render/overlay.h"
#include "temporary_folder.h"

namespace taut {
namespace {

Image deep_noise(Size size, int channels) {
  Image image = Image::blank(size, channels, 16);
  std::uint32_t state = 7;
  for (std::uint8_t& value : image.pixels) {
    state = state * 1664525U + 1013904223U;
    value = static_cast<std::uint8_t>(state >> 24U);
  }
  return image;
}

std::uint16_t sample_at(const Image& image, std::size_t number) {
  std::uint16_t sample = 0;
  std::memcpy(&sample, image.pixels.data() + 2 * number, 2);
  return sample;
}

std::string text_of(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

TEST(Tiff, KeepsEveryBit) {
  for (const int channels : {3, 4}) {
    const Image image = deep_noise({37, 21}, channels);
    const Image back = decode_frame(text_of(encode_frame(image)), 16, "a.tif");
    EXPECT_EQ(back.size.width, 37);
    EXPECT_EQ(back.size.height, 21);
    EXPECT_EQ(back.channels, channels);
    EXPECT_EQ(back.bits, 16);
    EXPECT_EQ(back.pixels, image.pixels);
  }
}

TEST(Tiff, IsTheSameFileForTheSamePicture) {
  EXPECT_EQ(encode_tiff(deep_noise({40, 30}, 4)), encode_tiff(deep_noise({40, 30}, 4)));
}

TEST(Tiff, IsSmallWhereLittleChanges) {
  Image image = Image::blank({640, 360}, 3, 16);
  EXPECT_LT(encode_tiff(image).size(), image.pixels.size() / 50);
}

TEST(Tiff, WhatIsCutOrOfAnotherKindIsNoFrame) {
  const testing::TemporaryFolder folder;
  const std::string whole = text_of(encode_tiff(deep_noise({40, 30}, 3)));
  EXPECT_TRUE(is_whole_frame(folder.write("whole.tif", whole), {40, 30}, 16));
  EXPECT_FALSE(is_whole_frame(folder / "whole.tif", {30, 40}, 16));
  EXPECT_FALSE(is_whole_frame(folder / "whole.tif", {40, 30}, 8)) << "no PNG";
  EXPECT_FALSE(is_whole_frame(folder / "none.tif", {40, 30}, 16));
  for (std::size_t length = 0; length < whole.size(); length += 97)
    EXPECT_FALSE(is_whole_frame(folder.write("cut.tif", whole.substr(0, length)), {40, 30}, 16)) << length;
  EXPECT_THROW(decode_tiff(std::string(500, 'x'), "x.tif"), RunFailure);
  EXPECT_THROW(decode_tiff("", "x.tif"), RunFailure);
}

TEST(DeepOverlay, BlendsBetweenTheStepsOfEightBits) {
  Image image = Image::blank({1, 1}, 4, 16);
  fill_rectangle(image, {0.0, 0.0, 1.0, 1.0}, {{0.2, 0.4, 0.6}, 1.0});
  EXPECT_EQ(sample_at(image, 0), 13107);
  EXPECT_EQ(sample_at(image, 1), 26214);
  EXPECT_EQ(sample_at(image, 3), 65535);
  fill_rectangle(image, {0.0, 0.0, 1.0, 1.0}, {{1.0, 1.0, 1.0}, 0.001});
  EXPECT_EQ(sample_at(image, 0), 13159) << "a thousandth of the way to white";
}

TEST(DeepOverlay, PicturesOfOtherDepthsAreNotPutTogether) {
  Image sheet = Image::blank({4, 4}, 3, 16);
  EXPECT_THROW(place_image(sheet, 0, 0, Image::blank({2, 2}, 3)), RunFailure);
  const Image inset = deep_noise({2, 2}, 3);
  place_image(sheet, 1, 1, inset);
  EXPECT_EQ(sample_at(sheet, 3 * (4 + 1)), sample_at(inset, 0));
  EXPECT_EQ(sample_at(sheet, 0), 0);
}

}  // namespace
}  // namespace taut
