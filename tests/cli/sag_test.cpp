#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.h"

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
