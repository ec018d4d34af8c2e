#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "metrics_lines.h"
#include "program.h"

// Runs that are killed at moments of no one's choosing, and run again until they are done: what they leave is
// what the undisturbed run leaves.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// A sheet that tears: long enough for a checkpoint or two, quick to draw. Its eye is given: looking for one
// would be done again every time.
std::string torn_sheet() {
  return R"([world]
duration = 3
[solve]
method = "xpbd"
steps_per_second = 4000
passes = 8
[camera]
eye = [0.5, 0.5, 3]
target = [0.5, 0.5, 0]
[look]
colour_by = "strain"
[[sheet]]
name = "cloth"
rows = 30
columns = 30
from = [0, 1, 0]
to = [1, 1, 0]
down = [0, -1, 0.2]
pinned = ["top-left", "top-right"]
stiffness = 2000
break_stretch = 1.3
[[load]]
masses = ["cloth.29.*"]
force = [0, -3, 0]
from = 0.5
to = 2
)";
}

// How often a program is killed all in all; TAUT_KILLS asks for more.
int kills_wanted() {
  const char* text = std::getenv("TAUT_KILLS");
  return text == nullptr ? 5 : std::atoi(text);
}

// Runs a command, killing it after so long (s); whether it came to its end before.
bool survives(const Words& words, double seconds, const Environment& environment) {
  std::string command = fmt::format("timeout -s KILL {:.3f} '" TAUT_PROGRAM "'", seconds);
  for (const std::string& word : words) command += fmt::format(" '{}'", word);
  const Ran ran = run_program("/bin/sh", {"-c", command}, environment);
  EXPECT_TRUE(ran.status == 0 || ran.status == 137) << command << "\n" << ran.err;
  return ran.status == 0;
}

class KilledTest : public ::testing::Test {
 protected:
  // Runs a command undisturbed, and keeps how long that took (s).
  void run_whole(const Words& words) {
    const auto start = std::chrono::steady_clock::now();
    const Ran ran = taut(words, environment_);
    ASSERT_EQ(ran.status, 0) << ran.err;
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fs::remove_all(folder_ / "cache");
  }
  // Kills a command at random moments of the time that it takes undisturbed, as often as is wanted, beginning
  // anew where it comes to its end before; then lets it come to its end.
  void kill_often(const Words& words, const std::string& output, const std::string& film, unsigned seed) {
    const int kills = kills_wanted();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> moment(0.01, seconds_);
    int killed = 0;
    for (int tries = 0; killed < kills && tries < 10 * kills; ++tries) {
      if (!survives(words, moment(random), environment_)) {
        ++killed;
      } else {
        if (!output.empty()) fs::remove_all(folder_ / output);
        fs::remove_all(folder_ / (film + ".mp4"));
        fs::remove_all(folder_ / (film + ".jsonl"));
        fs::remove_all(folder_ / "cache");
      }
    }
    RecordProperty("kills", killed);
    EXPECT_EQ(killed, kills);
    const Ran last = taut(words, environment_);
    EXPECT_EQ(last.status, 0) << last.err;
    // And once more: the same command twice is quiet success.
    EXPECT_EQ(taut(words, environment_).status, 0);
  }
  static std::map<std::string, std::string> files_in(const fs::path& folder, const std::string& ending) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ending)
        files[entry.path().lexically_relative(folder).string()] = read_file(entry.path());
    return files;
  }
  static Json manifest_in(const fs::path& folder) { return Json::parse(read_file(folder / "manifest.json")); }

  TemporaryFolder folder_;
  double seconds_ = 0.0;
  std::string scene_ = folder_.write("torn.toml", torn_sheet());
  Environment environment_{{"TAUT_CACHE", folder_ / "cache"}};
};

TEST_F(KilledTest, RenderWithAFilmAndMetrics) {
  const auto words = [&](const std::string& name) {
    return Words{"render",    scene_,
                 "-o",        folder_ / name,
                 "--film",    folder_ / (name + ".mp4"),
                 "--metrics", folder_ / (name + ".jsonl"),
                 "--size",    "64x48",
                 "--threads", "2"};
  };
  ASSERT_NO_FATAL_FAILURE(run_whole(words("whole")));
  kill_often(words("killed"), "killed", "killed", 1);
  EXPECT_EQ(files_in(folder_ / "whole", ".png"), files_in(folder_ / "killed", ".png"));
  EXPECT_EQ(manifest_in(folder_ / "whole")["frames"], manifest_in(folder_ / "killed")["frames"]);
  EXPECT_TRUE(read_file(folder_ / "whole.mp4") == read_file(folder_ / "killed.mp4"));
  const std::string whole = read_file(folder_ / "whole.jsonl");
  EXPECT_EQ(lines_of(whole).size(), 90U);
  EXPECT_TRUE(measured_part(whole) == measured_part(read_file(folder_ / "killed.jsonl")));
  EXPECT_EQ(taut({"verify", folder_ / "killed"}).status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "killed/checkpoint.bin")) << "what is whole needs none";
}

// Killed as soon as there is a checkpoint: what was measured before it comes out of it.
TEST_F(KilledTest, MetricsGoOnFromACheckpoint) {
  const auto words = [&](const std::string& name) {
    return Words{"render", scene_,    "-o",    folder_ / name, "--metrics", folder_ / (name + ".jsonl"),
                 "--size", "320x240", "--json"};
  };
  ASSERT_EQ(taut(words("whole"), environment_).status, 0);
  std::string command = "'" TAUT_PROGRAM "'";
  for (const std::string& word : words("killed")) command += fmt::format(" '{}'", word);
  run_program("/bin/sh",
              {"-c", fmt::format("{} & while [ ! -e '{}' ] && kill -0 $!; do sleep 0.01; done; kill -KILL $!",
                                 command, folder_ / "killed/checkpoint.bin")},
              environment_);
  const Ran again = taut(words("killed"), environment_);
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_GT(Json::parse(again.out)["resumed_at_frame"], 1) << again.out;
  EXPECT_TRUE(measured_part(read_file(folder_ / "whole.jsonl")) ==
              measured_part(read_file(folder_ / "killed.jsonl")));
}

TEST_F(KilledTest, Simulate) {
  const auto words = [&](const std::string& name) { return Words{"simulate", scene_, "-o", folder_ / name}; };
  ASSERT_NO_FATAL_FAILURE(run_whole(words("whole")));
  kill_often(words("killed"), "killed", "none", 2);
  EXPECT_TRUE(read_file(folder_ / "whole/motion.bin") == read_file(folder_ / "killed/motion.bin"));
  EXPECT_EQ(manifest_in(folder_ / "whole")["frames"], manifest_in(folder_ / "killed")["frames"]);
  EXPECT_EQ(taut({"verify", folder_ / "killed", "--deep"}).status, 0);
}

TEST_F(KilledTest, Stability) {
  const auto words = [&](const std::string& name) {
    return Words{"stability", "level-chain", "--methods", "xpbd,rattle",  "--axes",     "step,mass-ratio",
                 "--grid",    "6x4",         "-o",        folder_ / name, "--duration", "0.2"};
  };
  ASSERT_NO_FATAL_FAILURE(run_whole(words("whole")));
  kill_often(words("killed"), "killed", "none", 3);
  const auto maps = [&](const std::string& name) { return files_in(folder_ / name, ".csv"); };
  EXPECT_EQ(maps("whole"), maps("killed"));
  EXPECT_FALSE(maps("killed").empty());
}

// Times differ from run to run; errors don't.
TEST_F(KilledTest, Chart) {
  const auto words = [&](const std::string& name) {
    return Words{"chart", "pendulum", "--methods", "rattle", "--horizon", "0.5s", "-o", folder_ / name};
  };
  ASSERT_NO_FATAL_FAILURE(run_whole(words("whole")));
  kill_often(words("killed"), "killed", "none", 4);
  const auto errors = [&](const std::string& name) {
    std::map<std::string, Json> by_settings;
    const Json chart = Json::parse(read_file(fs::path(folder_ / name) / "pendulum.json"));
    for (const Json& one : chart["cases"]) by_settings[one["settings"].dump()] = one["errors"];
    return by_settings;
  };
  EXPECT_EQ(errors("whole"), errors("killed"));
  EXPECT_GT(errors("killed").size(), 3U);
}

TEST_F(KilledTest, Merge) {
  for (const std::string part : {"1/3", "2/3", "3/3"})
    ASSERT_EQ(taut({"render", scene_, "-o", folder_ / "parts", "--size", "64x48", "--shard", part}).status,
              0);
  const auto merge = [&](const std::string& name) {
    return Words{"merge", folder_ / name, "--film", folder_ / (name + ".mp4")};
  };
  fs::copy(folder_ / "parts", folder_ / "copy");
  ASSERT_NO_FATAL_FAILURE(run_whole(merge("copy")));
  kill_often(merge("parts"), "", "parts", 5);
  ASSERT_EQ(
      taut({"render", scene_, "-o", folder_ / "whole", "--film", folder_ / "whole.mp4", "--size", "64x48"})
          .status,
      0);
  EXPECT_EQ(files_in(folder_ / "whole", ".png"), files_in(folder_ / "parts", ".png"));
  EXPECT_TRUE(read_file(folder_ / "whole.mp4") == read_file(folder_ / "parts.mp4"));
}

// What is done again after a stop is no more than what lies between two checkpoints.
TEST_F(KilledTest, GoesOnFromTheLastCheckpoint) {
  const std::string motion = folder_ / "motion";
  const std::string script =
      fmt::format("'" TAUT_PROGRAM
                  "' simulate '{0}' --set world.duration=12 -o '{1}' & process=$!; "
                  "while kill -0 $process && [ ! -e '{1}/checkpoint.bin' ]; do sleep 0.01; done; "
                  "kill -KILL $process; wait $process",
                  scene_, motion);
  ASSERT_EQ(run_program("/bin/sh", {"-c", script}, environment_).status, 137)
      << "it ended before a checkpoint";
  const Ran ran =
      taut({"simulate", scene_, "--set", "world.duration=12", "-o", motion, "--json"}, environment_);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json outcome = Json::parse(ran.out);
  EXPECT_GT(outcome["resumed_at_frame"], 1);
  EXPECT_LE(outcome["resumed_at_frame"].get<int>(), outcome["frames"]["kept"].get<int>() + 1);
}

// A film that is gone on with takes the frames before the checkpoint from their files.
TEST_F(KilledTest, AFilmGoesOnFromTheLastCheckpoint) {
  const auto words = [&](const std::string& name) {
    return fmt::format("'" TAUT_PROGRAM
                       "' render '{}' --set world.duration=12 --size 64x48 -o '{}' --film '{}.mp4'",
                       scene_, folder_ / name, folder_ / name);
  };
  const std::string script = fmt::format(
      "{} & process=$!; while kill -0 $process && [ ! -e '{}/checkpoint.bin' ]; do sleep 0.01; done; "
      "kill -KILL $process; wait $process",
      words("killed"), folder_ / "killed");
  ASSERT_EQ(run_program("/bin/sh", {"-c", script}).status, 137) << "it ended before a checkpoint";
  const Ran again = run_program("/bin/sh", {"-c", words("killed")});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("went on at frame"), std::string::npos) << again.err;
  ASSERT_EQ(run_program("/bin/sh", {"-c", words("whole")}).status, 0);
  EXPECT_TRUE(read_file(folder_ / "whole.mp4") == read_file(folder_ / "killed.mp4"));
  EXPECT_EQ(files_in(folder_ / "whole", ".png"), files_in(folder_ / "killed", ".png"));
}

}  // namespace
}  // namespace taut::testing
