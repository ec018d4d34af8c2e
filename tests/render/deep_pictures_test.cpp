// Pictures of 16 bits a channel are those of 8, in finer steps.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

#include "layers.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::all_kinds;
using testing::draw_once;
using testing::size;

const CameraPose from_the_side{{1.5, 1.6, 4.2}, {0.0, 0.8, 0.0}, 38.0};

Image of_bits(int bits, bool transparent, int samples) {
  const Built scene = all_kinds();
  Look look;
  look.surface = true;
  RenderSettings settings{.size = size, .samples = samples, .transparent = transparent, .bits = bits};
  return draw_once(scene.model, scene.start, look, settings, from_the_side);
}

int sixteen_at(const Image& image, std::size_t sample) {
  std::uint16_t value = 0;
  std::memcpy(&value, image.pixels.data() + 2 * sample, 2);
  return value;
}

TEST(DeepPictures, AreThoseOfEightBitsInFinerSteps) {
  for (const bool transparent : {false, true})
    for (const int samples : {1, 4, 8}) {
      const Image coarse = of_bits(8, transparent, samples), fine = of_bits(16, transparent, samples);
      ASSERT_EQ(fine.pixels.size(), 2 * coarse.pixels.size());
      EXPECT_EQ(fine.channels, transparent ? 4 : 3);
      std::size_t far = 0;
      std::set<int> values;
      for (std::size_t i = 0; i < coarse.pixels.size(); ++i) {
        const double eight = sixteen_at(fine, i) / 257.0;
        // Where little of a pixel is covered its straight colour is known to few steps.
        const bool faint = transparent && coarse.pixels[i / 4 * 4 + 3] < 64;
        if (!faint && std::abs(eight - coarse.pixels[i]) > 3.0) ++far;
        values.insert(sixteen_at(fine, i));
      }
      EXPECT_LT(far, coarse.pixels.size() / 1000) << transparent << ", " << samples;
      EXPECT_GT(values.size(), 2000U) << "more than the 256 steps of eight bits";
    }
}

TEST(DeepPictures, LayingOverIsExactAtTheEnds) {
  const auto pixel = [](std::array<std::uint16_t, 4> samples) {
    Image image = Image::blank({1, 1}, 4, 16);
    std::memcpy(image.pixels.data(), samples.data(), 8);
    return image;
  };
  Image under = Image::blank({1, 1}, 3, 16);
  const std::array<std::uint16_t, 3> colour{65535, 12345, 1};
  std::memcpy(under.pixels.data(), colour.data(), 6);
  lay_over(under, 0, 0, pixel({0, 0, 0, 0}));
  EXPECT_EQ(sixteen_at(under, 1), 12345) << "nothing is laid over";
  lay_over(under, 0, 0, pixel({0, 0, 0, 32768}));
  EXPECT_EQ(sixteen_at(under, 0), 32767) << "black over half of it";
  lay_over(under, 0, 0, pixel({7, 8, 9, 65535}));
  EXPECT_EQ(sixteen_at(under, 2), 9) << "all of it";
}

}  // namespace
}  // namespace taut
