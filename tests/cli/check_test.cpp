#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

namespace taut::testing {
namespace {

using Json = nlohmann::json;

class CheckTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string good_ = folder_.write("good.toml", small_scene() + "[expect]\nmax_strain = 0.1\n");
  std::string failing_ = folder_.write("failing.toml", small_scene() + "[expect]\nat_rest = 1e-9\n");
  std::string bad_ = folder_.write("bad.toml", "[world]\nduratoin = 1\n");
};

TEST_F(CheckTest, AGoodSceneIsFine) {
  const Ran ran = taut({"check", good_});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "good: 2 masses, 1 links, 1 s with xpbd at 240 steps/s, fine\n");
}

TEST_F(CheckTest, WhatIsExpectedIsTestedOnlyByARun) {
  EXPECT_EQ(taut({"check", failing_}).status, 0);
  EXPECT_EQ(taut({"check", failing_, "--run"}).status, 1);
  EXPECT_EQ(taut({"check", good_, "--run"}).status, 0);
}

TEST_F(CheckTest, JsonHasAnObjectForEveryScene) {
  const Ran ran = taut({"check", good_, failing_, bad_, "--run", "--json"});
  EXPECT_EQ(ran.status, 2) << "the worst of them";
  const Json verdicts = Json::parse(ran.out);
  ASSERT_EQ(verdicts.size(), 3U);
  EXPECT_EQ(verdicts[0]["ok"], true);
  EXPECT_EQ(verdicts[0]["findings"][0]["key"], "max_strain");
  EXPECT_EQ(verdicts[0]["findings"][0]["holds"], true);
  EXPECT_EQ(verdicts[1]["ok"], false);
  EXPECT_EQ(verdicts[1]["findings"][0]["holds"], false);
  EXPECT_EQ(verdicts[2]["ok"], false);
  EXPECT_NE(verdicts[2]["problem"].get<std::string>().find("duratoin"), std::string::npos);
}

TEST_F(CheckTest, TheResolvedSceneIsTheSameScene) {
  const Ran resolved = taut({"check", good_, "--resolved"});
  ASSERT_EQ(resolved.status, 0) << resolved.err;
  const std::string again = folder_.write("again.toml", resolved.out);
  const Json first = Json::parse(taut({"check", good_, "--run", "--json"}).out);
  const Json second = Json::parse(taut({"check", again, "--run", "--json"}).out);
  EXPECT_EQ(first[0]["state_hash"], second[0]["state_hash"]);
  EXPECT_EQ(taut({"check", again, "--resolved"}).out, resolved.out);
}

}  // namespace
}  // namespace taut::testing
