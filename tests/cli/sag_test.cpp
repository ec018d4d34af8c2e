#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.h"
#include "read_picture.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(Sag, WritesSheetChartAndNumbers) {
  const TemporaryFolder folder;
  const Ran ran = taut({"sag", "hanging-chain-two-pins", "--passes", "4,16", "--size", "200x160", "--json",
                        "-o", folder / "sag"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* name : {"sag.png", "sag.csv", "sag.json", "sag-over-passes.png", "sag-over-passes.svg"})
    EXPECT_TRUE(fs::exists(folder.path() / "sag" / name)) << name;
  const Json json = Json::parse(ran.out);
  ASSERT_EQ(json.at("entries").size(), 2U);
  EXPECT_EQ(Json::parse(read_file(folder.path() / "sag" / "sag.json")), json);
  EXPECT_NEAR(json.at("exact").at("sag"), 0.7259, 1e-4);
  EXPECT_GT(json.at("entries")[0].at("sag_error"), json.at("entries")[1].at("sag_error"));
}

// Small panels leave little room for words: none may reach the edge.
TEST(Sag, NothingIsCutOffAtTheEdgeOfTheSheet) {
  const TemporaryFolder folder;
  const Ran ran =
      taut({"sag", "hanging-chain-two-pins", "--passes", "4", "--size", "120x100", "-o", folder / "sag"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Pixels sheet = read_picture(folder / "sag/sag.png");
  ASSERT_GT(sheet.width, 0);
  int inked = 0;
  for (int y = 0; y < sheet.height; ++y)
    for (const int x : {0, 1, 2, 3, sheet.width - 4, sheet.width - 3, sheet.width - 2, sheet.width - 1})
      for (int channel = 0; channel < 3; ++channel)
        inked += sheet.rgb.at(static_cast<std::size_t>(3 * (y * sheet.width + x) + channel)) != 255 ? 1 : 0;
  EXPECT_EQ(inked, 0);
}

TEST(Sag, AskedAgainItOnlyReadsWhatItFound) {
  const TemporaryFolder folder;
  const Environment cache{{"TAUT_CACHE", folder / "cache"}};
  const std::vector<std::string> words{
      "sag",         "hanging-chain-two-pins", "--passes", "4,16", "--size", "120x100", "--json", "-o",
      folder / "sag"};
  const Ran first = taut(words, cache);
  ASSERT_EQ(first.status, 0) << first.err;
  const std::string sheet = read_file(folder / "sag/sag.png");
  std::vector<fs::file_time_type> written;
  for (const auto& entry : fs::directory_iterator(folder / "cache"))
    written.push_back(entry.last_write_time());
  EXPECT_EQ(written.size(), 3U) << "two, and the exact one";
  const Ran second = taut(words, cache);
  EXPECT_EQ(second.out, first.out);
  EXPECT_EQ(read_file(folder / "sag/sag.png"), sheet);
  std::vector<fs::file_time_type> after;
  for (const auto& entry : fs::directory_iterator(folder / "cache")) after.push_back(entry.last_write_time());
  EXPECT_EQ(after, written);
}

TEST(Sag, EulersKeptVelocitiesAreShownOnceAsGrowing) {
  const TemporaryFolder folder;
  const Ran ran = taut({"sag", "hanging-chain", "--method", "euler", "--passes", "8", "--set",
                        "world.duration=1", "--size", "200x160", "--json", "-o", folder / "sag"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json entries = Json::parse(ran.out).at("entries");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_FALSE(entries[0].at("velocities_kept"));
  EXPECT_TRUE(entries[1].at("velocities_kept"));
  EXPECT_EQ(entries[1].at("time"), 1.0);
}

TEST(Sag, RefusesAMethodWithoutPasses) {
  const TemporaryFolder folder;
  const Ran ran = taut({"sag", "hanging-chain", "--method", "rattle", "-o", folder / "sag"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("verlet"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(Sag, RefusesPassesThatAreNone) {
  const TemporaryFolder folder;
  for (const char* passes : {"0", "2.5", "4,,8", "many"}) {
    const Ran ran = taut({"sag", "hanging-chain", "--passes", passes, "-o", folder / "sag"});
    EXPECT_EQ(ran.status, 2) << passes;
    EXPECT_NE(ran.err.find("--passes"), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace taut::testing
