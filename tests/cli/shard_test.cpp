#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "metrics_lines.h"
#include "program.h"

// One job dealt out to several processes gives what one process gives.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

class ShardTest : public ::testing::Test {
 protected:
  Words render(const std::string& name, const Words& more = {}) const {
    Words words{"render", scene_, "-o", folder_ / name, "--size", "64x48"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  static std::map<std::string, std::string> pictures_in(const fs::path& folder) {
    std::map<std::string, std::string> pictures;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".png")
        pictures[entry.path().filename().string()] = read_file(entry.path());
    return pictures;
  }
  // Metrics but for what stages took, which differs from run to run.
  static std::string measured(const std::string& text, const std::string& ending) {
    if (ending == ".jsonl") return measured_part(text);
    std::string kept;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      for (std::size_t stage = 0; stage < 7; ++stage) line.resize(line.rfind(','));
      kept += line + "\n";
    }
    return kept;
  }
  Json states_in(const std::string& name) const {
    return Json::parse(read_file(fs::path(folder_ / name) / "manifest.json"))["frames"];
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
};

TEST_F(ShardTest, FramesOfFourShardsAreThoseOfOneProcess) {
  ASSERT_EQ(taut(render("whole", {"--film", folder_ / "whole.mp4"})).status, 0);
  for (int i = 4; i >= 1; --i)
    ASSERT_EQ(taut(render("parts", {"--shard", fmt::format("{}/4", i)})).status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "parts/manifest.json")) << "no shard speaks for all";
  EXPECT_EQ(taut({"verify", folder_ / "parts"}).status, 0) << "of shards, too";
  const Ran merged = taut({"merge", folder_ / "parts", "--film", folder_ / "parts.mp4"});
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(pictures_in(folder_ / "whole"), pictures_in(folder_ / "parts"));
  EXPECT_EQ(states_in("whole"), states_in("parts"));
  EXPECT_TRUE(read_file(folder_ / "whole.mp4") == read_file(folder_ / "parts.mp4"));
  EXPECT_EQ(taut(render("parts", {"--film", folder_ / "parts.mp4"})).status, 0) << "nothing is left to do";
}

TEST_F(ShardTest, TwoFoldersAreJoinedInAThird) {
  ASSERT_EQ(taut(render("whole")).status, 0);
  ASSERT_EQ(taut(render("a", {"--shard", "1/2"})).status, 0);
  ASSERT_EQ(taut(render("b", {"--shard", "2/2"})).status, 0);
  const Words merge{"merge", folder_ / "a", folder_ / "b", "-o", folder_ / "both"};
  for (int again = 0; again < 2; ++again) {
    const Ran ran = taut(merge);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(pictures_in(folder_ / "whole"), pictures_in(folder_ / "both"));
  }
  EXPECT_EQ(taut({"merge", folder_ / "a", folder_ / "b"}).status, 2) << "where to is not said";
}

TEST_F(ShardTest, MergeNamesTheHoles) {
  for (const std::string part : {"1/3", "3/3"}) ASSERT_EQ(taut(render("parts", {"--shard", part})).status, 0);
  fs::remove(folder_ / "parts/frame-000002.png");
  const Ran ran = taut({"merge", folder_ / "parts", "--film", folder_ / "film.mp4"});
  EXPECT_EQ(ran.status, 3);
  EXPECT_NE(ran.err.find("frames 2,11-20 are missing"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(folder_ / "film.mp4"));
  // What is missing is made by whoever is asked for it.
  EXPECT_EQ(taut(render("parts")).status, 0);
  EXPECT_EQ(taut({"merge", folder_ / "parts"}).status, 0);
}

TEST_F(ShardTest, OtherInputsAreNeverMixedIn) {
  ASSERT_EQ(taut(render("a", {"--shard", "1/2"})).status, 0);
  ASSERT_EQ(taut(render("b", {"--shard", "2/2", "--set", "world.drag=1"})).status, 0);
  EXPECT_EQ(taut({"merge", folder_ / "a", folder_ / "b", "-o", folder_ / "both"}).status, 4);
  EXPECT_EQ(taut(render("a", {"--shard", "2/2", "--set", "world.drag=1"})).status, 4);
  EXPECT_EQ(taut(render("a", {"--set", "world.drag=1"})).status, 4);
}

TEST_F(ShardTest, ASlurmArraySaysWhichPart) {
  ASSERT_EQ(taut(render("whole")).status, 0);
  for (const std::string task : {"5", "6", "7"})
    ASSERT_EQ(
        taut(render("parts"),
             {{"SLURM_ARRAY_TASK_ID", task}, {"SLURM_ARRAY_TASK_MIN", "5"}, {"SLURM_ARRAY_TASK_COUNT", "3"}})
            .status,
        0);
  EXPECT_EQ(taut({"merge", folder_ / "parts"}).status, 0);
  EXPECT_EQ(pictures_in(folder_ / "whole"), pictures_in(folder_ / "parts"));
}

TEST_F(ShardTest, AFilmNeedsAllFrames) {
  const Ran ran = taut(render("parts", {"--shard", "1/2", "--film", folder_ / "film.mp4"}));
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("taut merge"), std::string::npos) << ran.err;
}

TEST_F(ShardTest, AMotionIsDrawnInParts) {
  ASSERT_EQ(taut(render("whole")).status, 0);
  ASSERT_EQ(taut({"simulate", scene_, "-o", folder_ / "motion"}).status, 0);
  for (const std::string part : {"1/2", "2/2"}) {
    const Ran ran = taut({"render", "--motion", folder_ / "motion", "-o", folder_ / "parts", "--size",
                          "64x48", "--shard", part});
    ASSERT_EQ(ran.status, 0) << ran.err;
  }
  EXPECT_EQ(taut({"merge", folder_ / "parts"}).status, 0);
  EXPECT_EQ(states_in("whole"), states_in("parts"));
  EXPECT_EQ(pictures_in(folder_ / "whole"), pictures_in(folder_ / "parts"));
}

TEST_F(ShardTest, OnlyCameraAndLookOfAMotionCanBeChanged) {
  ASSERT_EQ(taut({"simulate", scene_, "-o", folder_ / "motion"}).status, 0);
  const auto draw = [&](const Words& more) {
    Words words{"render", "--motion", folder_ / "motion", "--size",
                "64x48",  "-o",       folder_ / "drawn",  "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words);
  };
  EXPECT_EQ(draw({"--set", "camera.eye=[0, 1, 9]", "--set", "look.theme=dark", "--frames", "5-9"}).status, 0);
  for (const Words& more :
       {Words{"--set", "world.drag=2"}, Words{"--method", "rattle"}, Words{"--fps", "60"},
        Words{"--set", "look.speed=[[0, 0.5]]"}, Words{"--certify"}, Words{"--accuracy", "1%"}}) {
    fs::remove_all(folder_ / "drawn");
    const Ran ran = draw(more);
    EXPECT_EQ(ran.status, 2) << more.front() << ran.err;
    EXPECT_FALSE(fs::exists(folder_ / "drawn")) << more.front();
  }
  EXPECT_EQ(taut({"render", "--motion", folder_ / "nothing"}).status, 2);
}

TEST_F(ShardTest, MapsOfFourShardsAreThoseOfOneProcess) {
  const auto map = [&](const std::string& name, const Words& more) {
    Words words{"stability", "level-chain", "--methods",  "xpbd", "--axes", "step,mass-ratio",
                "--grid",    "5x4",         "--duration", "0.2",  "-o",     folder_ / name};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words).status;
  };
  ASSERT_EQ(map("whole", {}), 0);
  for (int i = 1; i <= 3; ++i) ASSERT_EQ(map("parts", {"--shard", fmt::format("{}/4", i)}), 0);
  Ran merged = taut({"merge", folder_ / "parts"});
  EXPECT_EQ(merged.status, 3) << merged.err;
  EXPECT_NE(merged.err.find("shard 4 of 4 is missing"), std::string::npos) << merged.err;
  ASSERT_EQ(map("parts", {"--shard", "4/4"}), 0);
  merged = taut({"merge", folder_ / "parts"});
  EXPECT_EQ(merged.status, 0) << merged.err;
  ASSERT_EQ(map("parts", {}), 0);
  const std::string csv = "level-chain/step-mass-ratio/cells.csv";
  EXPECT_FALSE(read_file(fs::path(folder_ / "whole") / csv).empty());
  EXPECT_EQ(read_file(fs::path(folder_ / "whole") / csv), read_file(fs::path(folder_ / "parts") / csv));
}

using ShardedStudies = ShardTest;

TEST_F(ShardedStudies, EndInTheNumbersOfOneProcess) {
  const Environment environment{{"TAUT_CACHE", folder_ / "cache"}};
  const auto run_chart = [&](const std::string& name, const Words& more) {
    Words words{"chart", "pendulum", "--methods", "rattle,verlet", "--horizon", "0.3s", "-o", folder_ / name};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words, environment).status;
  };
  const auto errors = [&](const std::string& name) {
    std::map<std::string, Json> by_settings;
    const Json chart = Json::parse(read_file(fs::path(folder_ / name) / "pendulum.json"));
    for (const Json& one : chart["cases"]) by_settings[one["settings"].dump()] = one["errors"];
    return by_settings;
  };
  ASSERT_EQ(run_chart("whole", {}), 0);
  for (const std::string part : {"1/2", "2/2"}) ASSERT_EQ(run_chart("parts", {"--shard", part}), 0);
  EXPECT_EQ(taut({"merge", folder_ / "parts"}).status, 0);
  ASSERT_EQ(run_chart("parts", {}), 0);
  EXPECT_EQ(errors("whole"), errors("parts"));

  const auto sag = [&](const std::string& name, const Words& more) {
    Words words{"sag", "hanging-chain-two-pins", "--passes", "1,4,16",
                "-o",  folder_ / name,           "--size",   "64x48"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words, environment).status;
  };
  ASSERT_EQ(sag("sag", {}), 0);
  for (const std::string part : {"1/2", "2/2"}) ASSERT_EQ(sag("sag-parts", {"--shard", part}), 0);
  EXPECT_EQ(taut({"merge", folder_ / "sag-parts"}).status, 0);
  ASSERT_EQ(sag("sag-parts", {}), 0);
  EXPECT_EQ(read_file(folder_ / "sag/sag.csv"), read_file(folder_ / "sag-parts/sag.csv"));
}

// What one process measures stands in the shards' files, too, frame by frame.
TEST_F(ShardTest, MetricsOfShardsAreJoined) {
  for (const std::string ending : {".jsonl", ".csv"}) {
    const std::string file = "m" + ending;
    ASSERT_EQ(taut(render("frames", {"--overwrite", "--metrics", folder_ / ("whole" + ending)})).status, 0);
    for (const std::string part : {"1/3", "2/3", "3/3"})
      ASSERT_EQ(taut(render("parts", {"--metrics", folder_ / file, "--shard", part})).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / file));
    EXPECT_TRUE(fs::exists(folder_ / ("m-2-of-3" + ending)));
    const Words merge{"merge", folder_ / "parts", "--metrics", folder_ / file};
    for (int again = 0; again < 2; ++again) {
      const Ran ran = taut(merge);
      EXPECT_EQ(ran.status, 0) << ran.err;
      EXPECT_EQ(measured(read_file(folder_ / ("whole" + ending)), ending),
                measured(read_file(folder_ / file), ending));
    }
    EXPECT_EQ(taut({"verify", folder_ / "parts"}).status, 0);
    fs::remove(folder_ / ("m-2-of-3" + ending));
    EXPECT_EQ(taut({"verify", folder_ / "parts"}).status, 0) << "it stands in the file they became";
    fs::remove(folder_ / file);
    EXPECT_EQ(taut({"verify", folder_ / "parts"}).status, 5) << "that one is known";
    fs::remove_all(folder_ / "parts");
  }
}

TEST_F(ShardTest, HolesInMetricsAreNamed) {
  const auto part = [&](const std::string& which) {
    return render("parts", {"--metrics", folder_ / "m.jsonl", "--shard", which});
  };
  for (const std::string which : {"1/3", "2/3", "3/3"}) ASSERT_EQ(taut(part(which)).status, 0);
  const std::string whole = read_file(folder_ / "m-2-of-3.jsonl");
  std::string edited = whole;
  edited[whole.find("total_energy") + 16] ^= 1;
  folder_.write("m-2-of-3.jsonl", edited);
  const Words merge{"merge", folder_ / "parts", "--metrics", folder_ / "m.jsonl"};
  const Ran ran = taut(merge);
  EXPECT_EQ(ran.status, 3);
  EXPECT_NE(ran.err.find("metrics of frames 11-20 are missing"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(folder_ / "m.jsonl"));
  // Who has another kind of file is told; who makes it anew goes on.
  EXPECT_EQ(taut({"merge", folder_ / "parts", "--metrics", folder_ / "m.csv"}).status, 2);
  folder_.write("m-2-of-3.jsonl", whole);
  EXPECT_EQ(taut(merge).status, 0);
  EXPECT_EQ(lines_of(read_file(folder_ / "m.jsonl")).size(), 30U);
}

}  // namespace
}  // namespace taut::testing
