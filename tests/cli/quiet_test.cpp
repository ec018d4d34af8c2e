// --quiet leaves out progress and summaries, never why the exit status isn't 0.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "program.h"

namespace taut::testing {
namespace {

using Words = std::vector<std::string>;

void expect_reason(const Ran& ran, int status, const std::string& reason) {
  EXPECT_EQ(ran.status, status) << ran.err;
  EXPECT_NE(ran.err.find(reason), std::string::npos) << "stderr: " << ran.err;
}

// Where the signal comes before anything has begun, that is the reason.
void expect_interrupted(const Ran& ran, const std::string& reason) {
  const bool before = ran.err.find("interrupted; nothing was written") != std::string::npos;
  expect_reason(ran, 130, before ? "interrupted; nothing was written" : reason);
}

class QuietTest : public ::testing::Test {
 protected:
  // Runs a verb on the small scene.
  Ran quiet(const std::string& verb, const Words& more) const {
    Words words{verb, scene_, "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words, {{"TAUT_CACHE", folder_ / "cache"}});
  }

  // Starts a verb on a scene that lasts an hour in fine steps, and interrupts it as soon as it is ready to be
  // interrupted.
  Ran interrupted(const std::string& verb, const Words& more) const {
    std::string words;
    for (const std::string& word : more) words += " '" + word + "'";
    const std::string script = "'" TAUT_PROGRAM "' " + verb + " '" + scene_ +
                               "' --quiet --set world.duration=3600 --set steps_per_second=10000" + words +
                               " & process=$!\n" + until_it_listens + "kill -INT $process; wait $process";
    return run_program("/bin/sh", {"-c", script});
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene() + "[expect]\nbroken_links = [1, 1]\n");
};

TEST_F(QuietTest, AnExpectationThatFails) {
  expect_reason(quiet("check", {"--run"}), 1, "broken_links");
  expect_reason(quiet("check", {"--run", "--json"}), 1, "broken_links");
}

TEST_F(QuietTest, AChartWhoseBudgetIsSpent) {
  expect_reason(quiet("chart", {"-o", folder_ / "chart", "--budget", "0.001s"}), 3,
                "running the same again goes on");
}

TEST_F(QuietTest, AMapThatIsNotWhole) {
  expect_reason(quiet("stability", {"--draw-only", "--axes", "step,gravity", "--grid", "2x2", "--methods",
                                    "xpbd", "-o", folder_ / "maps"}),
                3, "0 of 2 columns; the others are still to be run");
}

TEST_F(QuietTest, APanelThatFailsWhileOthersGoOn) {
  folder_.write("small.toml", scene_with_a_jumping_pin());
  expect_reason(quiet("compare", {"--methods", "rattle,xpbd", "-o", folder_ / "frames", "--size", "64x48"}),
                0, "the panel of rattle went no further");
}

TEST_F(QuietTest, InterruptedRuns) {
  expect_interrupted(interrupted("render", {"-o", folder_ / "frames", "--size", "64x48"}), "interrupted; ");
  expect_interrupted(interrupted("render", {"--no-frames", "--film", folder_ / "a.gif", "--size", "64x48"}),
                     "interrupted; ");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.gif"));
  expect_interrupted(
      interrupted("compare", {"--methods", "rattle,xpbd", "-o", folder_ / "compared", "--size", "64x48"}),
      "interrupted; ");
  expect_interrupted(interrupted("check", {"--run"}), "was not checked to its end");
  expect_interrupted(interrupted("export", {"-o", folder_ / "table.csv", "--times", "3599"}),
                     "no file was written");
  expect_interrupted(interrupted("sag", {"-o", folder_ / "sag", "--passes", "3000,3001"}),
                     "running the same again goes on");
  expect_interrupted(interrupted("chart", {"-o", folder_ / "chart"}), "running the same again goes on");
  expect_interrupted(interrupted("stability", {"--axes", "step,gravity", "-o", folder_ / "maps"}),
                     "running the same again goes on");
}

TEST_F(QuietTest, FilesThatCannotBeWritten) {
  const std::string below = folder_.write("file", "") + "/below.png";
  expect_reason(quiet("still", {"--at", "0", "-o", below}), 1, "can't write");
  expect_reason(quiet("strip", {"-o", below}), 1, "can't write");
  expect_reason(quiet("export", {"-o", below}), 1, "can't write");
}

}  // namespace
}  // namespace taut::testing
