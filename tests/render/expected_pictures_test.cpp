// Pictures compared with stored ones in expected/. After an intended change of looks, run this test once with
// TAUT_UPDATE_PICTURES=1 in the environment: it then writes the pictures instead. Look at them before keeping
// them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>
#include <string>

#include "render/renderer.h"
#include "small_scenes.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace taut {
namespace {

struct Picture {
  std::string name;
  Built scene;
  Look look;
  CameraPose pose{{1.6, 1.9, 5.2}, {0.0, 1.2, 0.0}, 38.0};
  bool transparent = false;
};

void PrintTo(const Picture& picture, std::ostream* out) {
  *out << picture.name;
}

Built hanging_row() {
  std::vector<Vec3> positions;
  for (int i = 0; i <= 12; ++i) {
    const double x = -1.2 + 0.2 * i;
    positions.push_back({x, 0.5 + x * x, 0.0});
  }
  return testing::row_of_masses(positions);
}

Picture chain(Theme theme) {
  Picture picture{.name = theme == Theme::dark ? "chain-dark" : "chain", .scene = hanging_row(), .look = {}};
  picture.look.theme = theme;
  return picture;
}

Picture cloth(Pattern pattern, const std::string& name) {
  Picture picture{.name = name, .scene = testing::folded_sheet(13, 13), .look = {}};
  picture.pose = {{1.0, 1.9, 3.6}, {0.0, 1.2, 0.0}, 38.0};
  picture.look.surface = true;
  picture.look.masses = picture.look.links = false;
  picture.look.pattern = pattern;
  picture.look.thread_pitch = 0.12;  // so coarse that it shows in a small picture
  return picture;
}

Picture torn_cloth() {
  Picture picture = cloth(Pattern::checker, "torn-cloth");
  State& state = picture.scene.start;
  for (std::size_t link = 0; link < picture.scene.model.links.size(); ++link) {
    const Vec3 a = state.position.at(picture.scene.model.links.a[link]);
    const Vec3 b = state.position.at(picture.scene.model.links.b[link]);
    // A tear from the left edge past the middle.
    if (a.x() < 0.4 && a.y() > 1.2 && b.y() < 1.2) state.broken_at[link] = 0.0;
  }
  picture.look.links = true;
  return picture;
}

Picture strained_cloth() {
  Picture picture = cloth(Pattern::plain, "strained-cloth");
  picture.look.colour_by = ColourBy::strain;
  picture.look.colour_range = 0.2;
  return picture;
}

Picture cut_out_cloth() {
  Picture picture = cloth(Pattern::woven, "cut-out-cloth");
  picture.transparent = true;
  return picture;
}

struct Difference {
  int largest = 0;
  double mean = 0.0;
};

Difference compare(const Image& image, const unsigned char* expected) {
  Difference difference;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const int levels = std::abs(image.pixels[i] - expected[i]);
    difference.largest = std::max(difference.largest, levels);
    difference.mean += levels / static_cast<double>(image.pixels.size());
  }
  return difference;
}

class ExpectedPicture : public ::testing::TestWithParam<Picture> {};

TEST_P(ExpectedPicture, Matches) {
  const Picture& picture = GetParam();
  const Image image = testing::draw_once(
      picture.scene.model, picture.scene.start, picture.look,
      {.size = {160, 90}, .samples = 4, .shadow_map_size = 256, .transparent = picture.transparent},
      picture.pose);
  const std::string file = std::string(TAUT_TEST_DATA) + "/render/expected/" + picture.name + ".png";
  if (std::getenv("TAUT_UPDATE_PICTURES") != nullptr) {
    ASSERT_NE(0, stbi_write_png(file.c_str(), image.size.width, image.size.height, image.channels,
                                image.pixels.data(), 0));
    GTEST_SKIP() << "wrote " << file;
  }
  int width = 0, height = 0, channels = 0;
  unsigned char* expected = stbi_load(file.c_str(), &width, &height, &channels, 0);
  ASSERT_NE(nullptr, expected) << file;
  const bool same_kind =
      width == image.size.width && height == image.size.height && channels == image.channels;
  const Difference difference = same_kind ? compare(image, expected) : Difference{};
  stbi_image_free(expected);
  ASSERT_TRUE(same_kind) << file;
  // Other processors round differently: by a level anywhere, by a sample's worth on a few edges.
  EXPECT_LE(difference.mean, 0.25) << file;
  EXPECT_LE(difference.largest, 80) << file;
}

INSTANTIATE_TEST_SUITE_P(All, ExpectedPicture,
                         ::testing::Values(chain(Theme::light), chain(Theme::dark),
                                           cloth(Pattern::plain, "plain-cloth"),
                                           cloth(Pattern::woven, "woven-cloth"), torn_cloth(),
                                           strained_cloth(), cut_out_cloth()));

}  // namespace
}  // namespace taut
