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
using Json = nlohmann::json;
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
        for (const std::string ending : {".mp4", ".jsonl", ".csv"}) fs::remove_all(folder_ / (film + ending));
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
  // Runs a command and kills it as soon as a file is there.
  void kill_at(const Words& words, const std::string& file) {
    std::string command = "'" TAUT_PROGRAM "'";
    for (const std::string& word : words) command += fmt::format(" '{}'", word);
    const std::string script = fmt::format(
        "{} & process=$!; while kill -0 $process && [ ! -e '{}' ]; do sleep 0.01; done; "
        "kill -KILL $process; wait $process",
        command, folder_ / file);
    EXPECT_EQ(run_program("/bin/sh", {"-c", script}, environment_).status, 137) << "it ended before that";
  }
  // And runs it again to its end.
  Ran run_killed_at(const Words& words, const std::string& file) {
    kill_at(words, file);
    return taut(words, environment_);
  }
  // Everything in the test's folder that is hidden and no manifest of a film.
  std::vector<std::string> hidden_folders() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      if (entry.is_directory() && entry.path().filename().string().starts_with("."))
        names.push_back(entry.path().filename().string());
    return names;
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
  const Ran again = run_killed_at(words("killed"), "killed/checkpoint.bin");
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
  const Ran ran =
      run_killed_at({"simulate", scene_, "--set", "world.duration=12", "-o", folder_ / "motion", "--json"},
                    "motion/checkpoint.bin");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json outcome = Json::parse(ran.out);
  EXPECT_GT(outcome["resumed_at_frame"], 1);
  EXPECT_LE(outcome["resumed_at_frame"].get<int>(), outcome["frames"]["kept"].get<int>() + 1);
}

// A film that is gone on with takes the frames before the checkpoint from their files.
TEST_F(KilledTest, AFilmGoesOnFromTheLastCheckpoint) {
  const auto words = [&](const std::string& name) {
    return Words{"render", scene_,         "--set",  "world.duration=12",      "--size", "64x48",
                 "-o",     folder_ / name, "--film", folder_ / (name + ".mp4")};
  };
  const Ran again = run_killed_at(words("killed"), "killed/checkpoint.bin");
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("went on at frame"), std::string::npos) << again.err;
  ASSERT_EQ(taut(words("whole")).status, 0);
  EXPECT_TRUE(read_file(folder_ / "whole.mp4") == read_file(folder_ / "killed.mp4"));
  EXPECT_EQ(files_in(folder_ / "whole", ".png"), files_in(folder_ / "killed", ".png"));
}

// A film that is asked for alone: its frames are hidden until it is whole.
TEST_F(KilledTest, FilmWithoutFrames) {
  const auto words = [&](const std::string& name) {
    return Words{"render",     scene_,
                 "--film",     folder_ / (name + ".mp4"),
                 "--metrics",  folder_ / (name + ".jsonl"),
                 "--size",     "64x48",
                 "--threads",  "2",
                 "--no-frames"};
  };
  ASSERT_NO_FATAL_FAILURE(run_whole(words("whole")));
  kill_often(words("killed"), "", "killed", 6);
  EXPECT_TRUE(read_file(folder_ / "whole.mp4") == read_file(folder_ / "killed.mp4"));
  EXPECT_TRUE(measured_part(read_file(folder_ / "whole.jsonl")) ==
              measured_part(read_file(folder_ / "killed.jsonl")));
  EXPECT_EQ(hidden_folders(), std::vector<std::string>());
  EXPECT_EQ(taut({"verify", folder_ / "killed.mp4"}).status, 0);
}

TEST_F(KilledTest, AFilmAloneGoesOnFromTheLastCheckpoint) {
  const auto words = [&](const std::string& name, const Words& more = {}) {
    Words all{"render", scene_,  "--no-frames", "--film",           folder_ / (name + ".mp4"),
              "--size", "64x48", "--set",       "world.duration=12"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const std::string checkpoint = ".killed.mp4.frames/checkpoint.bin";
  const Ran again = run_killed_at(words("killed"), checkpoint);
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("went on at frame"), std::string::npos) << again.err;
  ASSERT_EQ(taut(words("whole")).status, 0);
  EXPECT_TRUE(read_file(folder_ / "whole.mp4") == read_file(folder_ / "killed.mp4"));
  EXPECT_EQ(hidden_folders(), std::vector<std::string>());
  // What another scene has left is of no use to this one, and goes with the film.
  fs::remove(folder_ / "killed.mp4");
  fs::remove(folder_ / ".killed.mp4.json");
  kill_at(words("killed", {"--set", "world.drag=1"}), checkpoint);
  ASSERT_EQ(taut(words("killed")).status, 0);
  EXPECT_TRUE(read_file(folder_ / "whole.mp4") == read_file(folder_ / "killed.mp4"));
  EXPECT_EQ(hidden_folders(), std::vector<std::string>());
}

// A run that fails would fail again: nothing is kept of it.
TEST_F(KilledTest, AFilmOfARunThatFailsLeavesNothing) {
  const std::string scene = folder_.write("jumping.toml", scene_with_a_jumping_pin());
  for (const Words& words :
       {Words{"render", scene, "--method", "rattle", "--no-frames", "--film", folder_ / "f.mp4"},
        Words{"export", scene, "--method", "rattle", "-o", folder_ / "f.csv"}}) {
    EXPECT_EQ(taut(words).status, 1);
    EXPECT_FALSE(fs::exists(folder_ / words.back()));
    EXPECT_EQ(hidden_folders(), std::vector<std::string>());
  }
}

TEST_F(KilledTest, Export) {
  const auto words = [&](const std::string& name) {
    return Words{"export", scene_, "-o", folder_ / (name + ".csv"), "--threads", "1"};
  };
  ASSERT_NO_FATAL_FAILURE(run_whole(words("whole")));
  kill_often(words("killed"), "", "killed", 7);
  EXPECT_TRUE(read_file(folder_ / "whole.csv") == read_file(folder_ / "killed.csv"));
  EXPECT_EQ(hidden_folders(), std::vector<std::string>());
}

// What is exported again is read where it was kept, simulated before that and after the checkpoint.
TEST_F(KilledTest, AnExportGoesOnFromTheLastCheckpoint) {
  for (const std::string table : {"masses", "energy"}) {
    const auto words = [&](const std::string& name) {
      return Words{"export",  scene_, "--set", "world.duration=12",
                   "--table", table,  "-o",    folder_ / (name + table + ".csv")};
    };
    const Ran again = run_killed_at(words("killed"), ".killed" + table + ".csv.motion/checkpoint.bin");
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_NE(again.err.find("the run goes on at"), std::string::npos) << again.err;
    ASSERT_EQ(taut(words("whole")).status, 0);
    EXPECT_TRUE(read_file(folder_ / ("whole" + table + ".csv")) ==
                read_file(folder_ / ("killed" + table + ".csv")));
    EXPECT_EQ(hidden_folders(), std::vector<std::string>());
  }
}

}  // namespace
}  // namespace taut::testing
