#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

// What becomes of a run that does not come to its end.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Starts a long render with a film, sends it a signal once its fifth frame is there, and waits for it.
Ran interrupted_render(const TemporaryFolder& folder, const std::string& signal) {
  const std::string scene = folder.write("small.toml", small_scene());
  const std::string script = "'" TAUT_PROGRAM "' render '" + scene + "' --set world.duration=3000 -o '" +
                             (folder / "frames") + "' --film '" + (folder / "film.mp4") +
                             "' --size 64x48 & process=$!; while [ ! -e '" + (folder / "frames") +
                             "/frame-000005.png' ]; do sleep 0.02; done; kill -" + signal +
                             " $process; wait $process";
  return run_program("/bin/sh", {"-c", script});
}

std::size_t count_of(const fs::path& folder, const std::string& ending) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) count += entry.path().extension() == ending;
  return count;
}

void expect_whole_frames_after(const std::string& signal, int status) {
  const TemporaryFolder folder;
  const Ran ran = interrupted_render(folder, signal);
  EXPECT_EQ(ran.status, status) << ran.err;
  EXPECT_NE(ran.err.find("small: note: to draw 9000"), std::string::npos) << "50 min of film: " << ran.err;
  const Json manifest = Json::parse(read_file(folder / "frames/manifest.json"));
  EXPECT_GE(manifest["frames"].size(), 5U);
  EXPECT_EQ(count_of(folder / "frames", ".png"), manifest["frames"].size());
  EXPECT_EQ(count_of(folder / "frames", ".part"), 0U);
  EXPECT_FALSE(fs::exists(folder / "film.mp4"));
  EXPECT_EQ(folder.entries(), 2U) << "the scene and the frames, and nothing half made";
}

class InterruptedTest : public ::testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(InterruptedTest, KeepsWholeFramesAndSaysSo) {
  expect_whole_frames_after(GetParam().first, GetParam().second);
}

// A terminal that goes away, and time that is used up.
TEST(Interrupted, ByWhateverElseComesFromOutside) {
  expect_whole_frames_after("HUP", 129);
  expect_whole_frames_after("XCPU", 152);
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptedTest,
                         ::testing::Values(std::pair("INT", 130), std::pair("TERM", 143)),
                         [](const auto& test) { return std::string(test.param.first); });

// A still or a strip of a long scene, stopped on the way to its last picture.
TEST_P(InterruptedTest, LeavesThePictureThatWasThere) {
  const auto [signal, status] = GetParam();
  for (const char* verb : {"still", "strip"}) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("small.toml", small_scene());
    const std::string picture = folder.write("picture.png", "what was there before");
    const std::string time = verb == std::string("still") ? "--at 3599" : "--count 3";
    const std::string script =
        std::string("'" TAUT_PROGRAM "' ") + verb + " '" + scene +
        "' --set world.duration=3600 --set solve.steps_per_second=100000 " + time + " --size 64x48 -o '" +
        picture + "' & process=$!; for i in $(seq 500); do ls -A '" + (folder / "") +
        "' | grep -q part && break; sleep 0.02; done; kill -" + signal + " $process; wait $process";
    const Ran ran = run_program("/bin/sh", {"-c", script});
    EXPECT_EQ(ran.status, status) << ran.err;
    EXPECT_NE(ran.err.find("interrupted"), std::string::npos) << ran.err;
    EXPECT_EQ(read_file(picture), "what was there before");
    EXPECT_EQ(folder.entries(), 2U) << "the scene and the picture, and nothing half made";
  }
}

// A search that would take a minute, and a first plan of many masses: stopped before anything is written.
TEST_P(InterruptedTest, EndsAPlanToo) {
  const auto [signal, status] = GetParam();
  for (const char* verb : {"render", "export", "check --run"}) {
    const TemporaryFolder folder;
    const std::string scene =
        folder.write("chain.toml",
                     "[world]\nduration = 20\n[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, "
                     "0]\nlinks = 200\npinned = [\"first\"]\n");
    const bool plans = verb != std::string("check --run");
    const std::string where =
        plans ? " --accuracy 0.01% --search 60s -o '" + (folder / "out") + "'" : " --certify";
    // Frames are there only once the plan is made.
    const std::string script = std::string("'" TAUT_PROGRAM "' ") + verb + " '" + scene + "'" + where +
                               " & process=$!\n" + until_it_listens + "sleep 0.2; kill -" + signal +
                               " $process; wait $process";
    const Ran ran = run_program("/bin/sh", {"-c", script}, {{"TAUT_CACHE", folder / "cache"}});
    EXPECT_EQ(ran.status, status) << verb << ran.err;
    EXPECT_NE(ran.err.find("interrupted"), std::string::npos) << verb << ran.err;
    EXPECT_FALSE(fs::exists(folder / "out")) << verb;
  }
}

// A step that takes seconds: newton on a net of forty thousand links. The signal comes half as long after the
// film has begun as that took. Whether the step's end or the end of patience comes first is the machine's
// affair (InterruptWatchDeathTest has both); the run ends as one that was interrupted, and whole.
TEST(Interrupted, EndsAStepThatTakesLong) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the thread sanitizer keeps a signal back until the thread calls the system";
#endif
  const TemporaryFolder folder;
  // An eye that is given, no ground, and a net that is hidden: looking for where it goes would run it
  // coarsely before the step, and to draw it takes as long as the step.
  const std::string scene = folder.write("net.toml", R"([world]
duration = 1
[camera]
eye = [1.5, 1.5, 6]
target = [1.5, 1.5, 0]
[look]
ground = false
[solve]
method = "newton"
steps_per_second = 30
[[sheet]]
name = "net"
visible = false
rows = 120
columns = 120
from = [0, 3, 0]
to = [3, 3, 0]
down = [0, -3, 0]
pinned = ["top-left", "top-right"]
diagonals = true
)");
  const std::string script =
      "begin=$(date +%s%N); '" TAUT_PROGRAM "' render '" + scene + "' --no-frames --film '" +
      (folder / "film.mp4") + "' --size 64x48 & process=$!; for i in $(seq 3000); do ls -A '" +
      (folder / "") +
      "' | grep -q part && break; sleep 0.02; done; "
      "sleep $(awk \"BEGIN { print ($(date +%s%N) - $begin) / 2e9 }\"); kill -TERM $process; wait $process";
  const Ran ran = run_program("/bin/sh", {"-c", script});
  EXPECT_EQ(ran.status, 143) << ran.err;
  EXPECT_NE(ran.err.find("taut: interrupted"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.entries(), 1U) << "the scene, and nothing half made";
}

// A terminal that goes away takes nothing with it that was started so that it stays.
TEST(Hangup, IsNothingUnderNohup) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const std::string script = "nohup '" TAUT_PROGRAM "' render '" + scene + "' --set world.duration=4 -o '" +
                             (folder / "frames") + "' --size 64x48 & process=$!; while [ ! -e '" +
                             (folder / "frames") +
                             "/frame-000005.png' ]; do sleep 0.02; done; kill -HUP $process; wait $process";
  const Ran ran = run_program("/bin/sh", {"-c", script});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(count_of(folder / "frames", ".png"), 120U);
}

TEST(Killed, TheNextRunGoesOnFromTheManifest) {
  const TemporaryFolder folder;
  EXPECT_EQ(interrupted_render(folder, "KILL").status, 137);
  const Ran again = taut({"render", folder / "small.toml", "--set", "world.duration=3000", "-o",
                          folder / "frames", "--size", "64x48", "--frames", "1-40"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_GE(count_of(folder / "frames", ".png"), 40U);
}

// A row of rigid links that is taut between two pins leaves a direct solver nothing to solve.
std::string unsolvable_scene() {
  return small_scene() + R"(
[[mass]]
name = "second-nail"
position = [2, 2, 0]
pinned = true
[[link]]
a = "bob"
b = "second-nail"
)";
}

TEST(Failed, AStepThatFailsKeepsTheFramesBeforeIt) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("taut.toml", unsolvable_scene());
  const Ran ran = taut({"render", scene, "-o", folder / "frames", "--film", folder / "film.mp4", "--size",
                        "64x48", "--method", "rattle"});
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_NE(ran.err.find("can't be solved with method rattle"), std::string::npos) << ran.err;
  EXPECT_EQ(count_of(folder / "frames", ".png"), 1U) << "the one at the start";
  EXPECT_FALSE(fs::exists(folder / "film.mp4"));
}

// Places that can't be written, even by root.
TEST(Failed, AnOutputThatCannotBeWrittenCostsNoSimulation) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const std::string file = folder.write("file", "");
  // Simulating this would take longer than the test may.
  const std::string endless = "world.duration=3600";
  const std::string fine = "steps_per_second=100000";
  for (const std::string& place : {file + "/below", std::string("/proc/frames")}) {
    const Ran frames = taut({"render", scene, "--set", endless, "--set", fine, "-o", place});
    EXPECT_EQ(frames.status, 1) << frames.err;
    EXPECT_NE(frames.err.find("can't make the folder " + place), std::string::npos) << frames.err;
    const Ran film =
        taut({"render", scene, "--set", endless, "--set", fine, "--no-frames", "--film", place + "/a.mp4"});
    EXPECT_EQ(film.status, 1) << film.err;
    EXPECT_NE(film.err.find("can't make the folder " + place), std::string::npos) << film.err;
  }
  const Ran still =
      taut({"still", scene, "--set", endless, "--set", fine, "--at", "3599", "-o", file + "/a.png"});
  EXPECT_EQ(still.status, 1) << still.err;
  EXPECT_NE(still.err.find("can't write"), std::string::npos) << still.err;
}

TEST(Failed, AMissingFilmEncoderCostsNoSimulationAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const Ran ran = taut({"render", scene, "--set", "world.duration=3600", "--set", "steps_per_second=100000",
                        "-o", folder / "frames", "--film", folder / "film.mp4"},
                       {{"PATH", "/nowhere"}});
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_NE(ran.err.find("ffmpeg"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(Failed, AnEncoderThatGivesUpIsQuotedAndLeavesNoFilm) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const std::string encoder =
      folder.write("ffmpeg", "#!/bin/sh\necho 'no room left in this encoder' >&2\nexit 1\n");
  fs::permissions(encoder, fs::perms::owner_all);
  const Ran ran = taut({"render", scene, "--no-frames", "--film", folder / "film.mp4", "--size", "64x48"},
                       {{"PATH", folder.path().string()}});
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_NE(ran.err.find("no room left in this encoder"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(folder / "film.mp4"));
  // Frames only stay where whoever tries again goes on with them: on a slow machine.
  EXPECT_EQ(folder.entries(), fs::exists(folder / ".film.mp4.frames/checkpoint.bin") ? 3U : 2U);
}

}  // namespace
}  // namespace taut::testing
