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

TEST_F(CheckTest, ARunIsCertifiedByASecondOne) {
  const Ran ran = taut({"check", good_, "--run", "--certify"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("certificate: against an integration of order 8 at acceleration level (dop853"),
            std::string::npos)
      << ran.out;
  const Json certificate =
      Json::parse(taut({"check", good_, "--run", "--certify", "--json"}).out)[0]["certificate"];
  EXPECT_GT(certificate["largest_difference"], 0.0);
  EXPECT_LT(certificate["share_of_size"], 0.1);
  EXPECT_EQ(certificate["until"], 1.0);
  EXPECT_TRUE(certificate["chaotic_from"].is_null());
  const Ran without = taut({"check", good_, "--certify"});
  EXPECT_EQ(without.status, 2);
  EXPECT_NE(without.err.find("--run"), std::string::npos) << without.err;
}

// Without [solve] a scene is planned by rule, and says how far that holds.
TEST_F(CheckTest, ASceneThatLeavesItsMethodOpenIsPlanned) {
  const std::string open = folder_.write(
      "open.toml",
      "[[chain]]\nname = \"r\"\nfrom = [0, 1, 0]\nto = [1, 1, 0]\nlinks = 5\npinned = [\"first\"]\n");
  const Ran ran = taut({"check", open, "--explain", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Json plan = Json::parse(ran.out)[0]["plan"];
  EXPECT_EQ(plan["searched"], false);
  EXPECT_GT(plan["judged_share"], 0.0);
  EXPECT_LE(plan["judged_share"], 1.0);
  EXPECT_GT(plan["size"], 0.9);
  EXPECT_FALSE(plan["reasons"].empty());
  EXPECT_NE(ran.err.find("of the size"), std::string::npos) << ran.err;
}

// Without stiffness its diagonals would say the same twice, which dop853 refuses: then that has no time.
TEST_F(CheckTest, ExplainsWhatTheMethodCanNotBeWithout) {
  const Ran ran = taut({"check", "curtain", "--method", "dop853", "--explain", "--quiet", "--json", "--set",
                        "sheet.0.rows=16", "--set", "sheet.0.columns=19"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(Json::parse(ran.out)[0].contains("explanation")) << ran.out.substr(0, 500);
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

TEST_F(CheckTest, WhatIsSeldomMeantIsNotedAndNoError) {
  const std::string taut_chain = folder_.write(
      "tight.toml",
      "[world]\nduration = 1\n[solve]\nmethod = \"xpbd\"\n[[chain]]\nname = \"rope\"\n"
      "from = [0, 0, 0]\nto = [1, 0, 0]\nlinks = 4\nmass = 1\npinned = [\"first\", \"last\"]\n");
  const Ran ran = taut({"check", taut_chain, "--json"});
  EXPECT_EQ(ran.status, 0);
  const Json notes = Json::parse(ran.out)[0]["notes"];
  ASSERT_EQ(notes.size(), 1U);
  const std::string note = notes[0].get<std::string>();
  EXPECT_NE(note.find("tight.toml:5:1: note: "), std::string::npos) << note;
  EXPECT_EQ(ran.err, "taut: " + note + "\n");
  EXPECT_EQ(taut({"check", taut_chain, "--quiet"}).err, "");
  const Ran exported = taut({"export", taut_chain, "--times", "0.1", "-o", folder_.path() / "tight.csv"});
  EXPECT_EQ(exported.status, 0);
  EXPECT_EQ(exported.err.find("taut: " + note + "\n"), 0U) << exported.err;
}

TEST_F(CheckTest, ARunTellsWhatIsLeftOfTheSpin) {
  const std::string spinning =
      folder_.write("spinning.toml",
                    "[world]\ngravity = [0, 0, 0]\nduration = 1\n[solve]\nmethod = \"rattle\"\n"
                    "[[mass]]\nname = \"a\"\nvelocity = [0, -3, 0]\nposition = [-0.5, 0, 0]\n"
                    "[[mass]]\nname = \"b\"\nvelocity = [0, 3, 0]\nposition = [0.5, 0, 0]\n[[link]]\na = "
                    "\"a\"\nb = \"b\"\n");
  const Json verdicts = Json::parse(taut({"check", spinning, good_, "--run", "--json"}).out);
  EXPECT_NEAR(verdicts[0]["spin"]["at_start"].get<double>(), 3.0, 1e-12);
  EXPECT_NEAR(verdicts[0]["spin"]["at_end"].get<double>(), 3.0, 1e-10);
  EXPECT_FALSE(verdicts[1].contains("spin")) << "a pin holds it";
  EXPECT_NE(taut({"check", spinning, "--run"}).out.find(", 100 %"), std::string::npos);
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

TEST(CheckNotes, SaysWhatALongRunWillTake) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const std::vector<std::string> words{
      "check", scene, "--set", "world.duration=3600", "--set", "steps_per_second=1000000"};
  const Ran ran = taut(words);
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("small: note: to simulate all 3600 s with xpbd takes about "), std::string::npos)
      << ran.err;
  EXPECT_EQ(taut({"check", scene}).err, "") << "a second is nothing to speak of";
}

TEST(CheckNotes, ARenderCountsItsPicturesToo) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const Ran ran = taut({"render", scene, "--frames", "1", "--size", "5000x5000", "-o", folder / "frames"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  // Four samples of eight bytes a pixel, and 24 bytes for what is made of them.
  EXPECT_NE(ran.err.find("takes about 1.4 GB and "), std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find("to draw"), std::string::npos) << "a picture is nothing to speak of: " << ran.err;
}

}  // namespace
}  // namespace taut::testing
