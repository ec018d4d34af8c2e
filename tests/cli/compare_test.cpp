#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "frames/panels.h"
#include "program.h"

namespace taut::testing {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

class CompareTest : public ::testing::Test {
 protected:
  Ran compare(const std::string& methods, const Words& more = {}) const {
    Words words{"compare", scene_, "--methods", methods, "-o", frames_, "--size", "64x48", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words);
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
  std::string frames_ = folder_ / "frames";
};

TEST_F(CompareTest, PutsMethodsSideBySideInStep) {
  const Ran ran = compare("rattle,xpbd:passes=3");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json summary = Json::parse(ran.out);
  EXPECT_EQ(summary["width"], 128);
  EXPECT_EQ(summary["height"], 48);
  EXPECT_EQ(summary["frames"]["there"], 30);
  ASSERT_EQ(summary["methods"].size(), 2U);
  EXPECT_EQ(summary["methods"][0]["method"], "rattle");
  const Json manifest = Json::parse(read_file(frames_ + "/manifest.json"));
  EXPECT_EQ(manifest["method"], "rattle, xpbd");
  EXPECT_EQ(manifest["settings"]["1.steps_per_second"], 240.0);
  EXPECT_EQ(manifest["settings"]["2.steps_per_second"], 240.0);
  EXPECT_EQ(manifest["settings"]["2.passes"], 3.0);
  EXPECT_EQ(manifest["width"], 128);
  // Each run is the one that render makes.
  const Ran alone =
      taut({"render", scene_, "--method", "rattle", "-o", folder_ / "alone", "--size", "64x48", "--json"});
  EXPECT_EQ(summary["methods"][0]["measures"], Json::parse(alone.out)["measures"]);
}

TEST_F(CompareTest, GoesOnWhereItStoppedAndMixesNothing) {
  ASSERT_EQ(compare("rattle,xpbd", {"--frames", "1-10"}).status, 0);
  const Json summary = Json::parse(compare("rattle,xpbd").out);
  EXPECT_EQ(summary["frames"]["kept"], 10);
  EXPECT_EQ(compare("rattle,xpbd:passes=2").status, 4) << "the second method's settings differ";
  EXPECT_EQ(compare("rattle,verlet").status, 4);
}

// The other method goes on.
TEST_F(CompareTest, AMethodThatFailsStaysWhereItWas) {
  folder_.write("small.toml", scene_with_a_jumping_pin());
  const Ran ran = compare("rattle,xpbd");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json methods = Json::parse(ran.out)["methods"];
  ASSERT_TRUE(methods[0].contains("failure")) << ran.out;
  EXPECT_NE(ran.err.find("can't be solved with method rattle"), std::string::npos) << ran.err;
  EXPECT_FALSE(methods[1].contains("failure"));
  EXPECT_NEAR(methods[0]["measures"]["time"].get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(methods[1]["measures"]["time"].get<double>(), 29.0 / 30.0, 1e-9);
}

// A spring too stiff for rattle's step: only making the method shows it.
TEST_F(CompareTest, ARefusalSaysWhosePanelItIsAndNothingIsWritten) {
  folder_.write("small.toml", small_scene() + "stiffness = 1e8\n");
  const Ran ran = compare("xpbd,rattle");
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_NE(ran.err.find("the panel of rattle, 240 steps/s: "), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(frames_)) << "nothing was written";
}

TEST_F(CompareTest, SaysWhatItCannotDo) {
  const auto error = [&](const std::string& methods) {
    const Ran ran = compare(methods);
    EXPECT_EQ(ran.status, 2) << ran.err;
    return ran.err;
  };
  EXPECT_NE(error("rattle").find("2 to 9 methods"), std::string::npos);
  EXPECT_NE(error("rattle,rattle").find("twice"), std::string::npos);
  EXPECT_NE(error("rattle,verlt").find("did you mean \"verlet\"?"), std::string::npos);
  EXPECT_NE(error("rattle,xpbd:pases=2").find("did you mean \"passes\"?"), std::string::npos);
  EXPECT_NE(error("rattle,spring-explicit").find("has no rigid links"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(frames_)) << "nothing was written";
}

TEST(SheetSize, IsARowOfUpToThreeAndThenNearlySquare) {
  const auto size = [](std::size_t count) {
    const Size sheet = sheet_size({10, 10}, count);
    return std::pair(sheet.width / 10, sheet.height / 10);
  };
  EXPECT_EQ(size(1), std::pair(1, 1));
  EXPECT_EQ(size(3), std::pair(3, 1));
  EXPECT_EQ(size(4), std::pair(2, 2));
  EXPECT_EQ(size(5), std::pair(3, 2));
  EXPECT_EQ(size(9), std::pair(3, 3));
}

}  // namespace
}  // namespace taut::testing
