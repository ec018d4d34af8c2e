// Pictures are coloured by what there is, or refused before anything is written.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"
#include "read_picture.h"

namespace taut::testing {
namespace {

using Words = std::vector<std::string>;

class ColourTest : public ::testing::Test {
 protected:
  static Ran run(Words words, const Words& more, const Words& still_more = {}) {
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), still_more.begin(), still_more.end());
    return taut(words);
  }

  // Every verb that makes pictures, of a scene into a place.
  std::vector<Words> verbs(const std::string& scene) const {
    const std::string place = folder_ / "made";
    return {{"render", scene, "--size", "64x48", "--frames", "1", "-o", place},
            {"still", scene, "--size", "64x48", "--at", "0.1s", "-o", place},
            {"strip", scene, "--size", "64x48", "--count", "2", "-o", place}};
  }

  TemporaryFolder folder_;
  std::string plain_ = folder_.write("plain.toml", small_scene());
  std::string tense_ = folder_.write("tense.toml", small_scene() + "[look]\ncolour_by = \"tension\"\n");
  std::string limit_ = folder_.write("limit.toml", small_scene() + "[look]\ncolour_by = \"limit\"\n");
};

TEST_F(ColourTest, TensionIsRefusedWhereTheMethodKnowsNone) {
  for (const auto& [scene, colour] : {std::pair{plain_, Words{"--colour", "tension"}}, {tense_, Words{}}})
    for (const Words& verb : verbs(scene)) {
      const Ran refused = run(verb, {"--method", "euler"}, colour);
      EXPECT_EQ(refused.status, 2) << verb[0];
      EXPECT_NE(refused.err.find("rattle"), std::string::npos) << refused.err;
      EXPECT_EQ(folder_.entries(), 3U) << verb[0] << " wrote something";
    }
}

TEST_F(ColourTest, LimitIsRefusedWhereThereAreNone) {
  for (const auto& [scene, colour] : {std::pair{plain_, Words{"--colour", "limit"}}, {limit_, Words{}}})
    for (const Words& verb : verbs(scene)) {
      const Ran refused = run(verb, colour);
      EXPECT_EQ(refused.status, 2) << verb[0];
      EXPECT_NE(refused.err.find("limits"), std::string::npos) << refused.err;
      EXPECT_EQ(folder_.entries(), 3U) << verb[0] << " wrote something";
    }
  EXPECT_EQ(taut({"check", limit_}).status, 2);
}

// Of two pictures side by side that show the same: how many pixels differ in the left lower part, and
// elsewhere.
struct Differing {
  int in_corner = 0, elsewhere = 0;
};
Differing halves_differ(const Pixels& both) {
  Differing found;
  const int width = both.width / 2;
  const auto pixel = [&](int x, int y) { return both.rgb.begin() + 3 * (y * both.width + x); };
  for (int y = 0; y < both.height; ++y)
    for (int x = 2; x < width - 2; ++x) {  // but for the rule between them
      if (std::equal(pixel(x, y), pixel(x, y) + 3, pixel(x + width, y))) continue;
      ++(5 * x < 3 * width && 2 * y >= both.height ? found.in_corner : found.elsewhere);
    }
  return found;
}

TEST_F(ColourTest, PicturesSideBySideSayOnceWhatColoursMean) {
  const Words same{"--set",        "world.gravity=[0, 0, 0]", "--colour", "strain", "--size", "320x180",
                   "--no-captions"};
  const std::string strip = folder_ / "strip.png", compared = folder_ / "compared";
  ASSERT_EQ(run({"strip", plain_, "--count", "2", "-o", strip}, same).status, 0);
  ASSERT_EQ(
      run({"compare", plain_, "--methods", "xpbd,verlet", "--frames", "1", "-o", compared}, same).status, 0);
  for (const std::string& picture : {strip, compared + "/frame-000001.png"}) {
    const Differing found = halves_differ(read_picture(picture));
    EXPECT_GT(found.in_corner, 500) << picture;
    EXPECT_EQ(found.elsewhere, 0) << picture;
  }
}

TEST_F(ColourTest, EveryOtherMethodHasTension) {
  for (const char* method : {"verlet", "xpbd", "shake", "rattle", "newton"}) {
    const Ran ran = taut({"still", plain_, "--method", method, "--colour", "tension", "--size", "64x48",
                          "--at", "0.1s", "-o", folder_ / "still.png"});
    EXPECT_EQ(ran.status, 0) << method << ": " << ran.err;
  }
}

TEST_F(ColourTest, SagTakesThemToo) {
  const Ran refused =
      taut({"sag", plain_, "--method", "euler", "--colour", "tension", "-o", folder_ / "sag"});
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_NE(refused.err.find("verlet"), std::string::npos) << refused.err;
  EXPECT_EQ(folder_.entries(), 3U);
  const Ran plain =
      taut({"sag", tense_, "--method", "euler", "--passes", "4", "--size", "64x48", "-o", folder_ / "sag"});
  EXPECT_EQ(plain.status, 0) << plain.err;
}

// What the scene asks for is left out of the panel of a method that has none; what is asked for beside it is
// refused.
TEST_F(ColourTest, APanelWithoutTensionStaysPlain) {
  const Words compare{"compare", "--methods", "euler,rattle", "--size", "64x48", "--frames", "10"};
  const Ran by_scene = run(compare, {tense_, "-o", folder_ / "by-scene", "--json"});
  ASSERT_EQ(by_scene.status, 0) << by_scene.err;
  const nlohmann::json methods = nlohmann::json::parse(by_scene.out)["methods"];
  EXPECT_TRUE(methods[0]["measures"]["largest_tension"].is_null()) << methods[0];
  EXPECT_TRUE(methods[1]["measures"]["largest_tension"].is_number()) << methods[1];
  EXPECT_EQ(run(compare, {plain_, "--colour", "tension", "-o", folder_ / "asked"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "asked"));
}

}  // namespace
}  // namespace taut::testing
