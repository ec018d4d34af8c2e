#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "program.h"
#include "program_on_the_path.h"

// Programs that taut starts and that never end. Each writes its number into a file, so that it can be looked
// for.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;

// A program that hangs, having read its input or not.
std::string hanging(const TemporaryFolder& folder, bool reads) {
  const std::string number = folder / "number";
  return std::string(reads ? "cat >/dev/null\n" : "") + "echo $$ >" + number + ".new\nmv " + number +
         ".new " + number + "\nexec sleep 600";
}

// Whether a process runs: one that has ended and is waited for does not.
bool runs(const std::string& process) {
  const std::string status = read_file("/proc/" + process + "/stat");
  return !status.empty() && status.find(") Z ") == std::string::npos;
}

struct Hanging {
  std::string name, program, arguments;
  bool reads;
};

class HangingChild : public ::testing::TestWithParam<Hanging> {
 protected:
  // Runs taut with that program, sends it a signal once the program hangs, and waits for it.
  Ran run_until_hanging(const std::string& signal) const {
    const auto& [name, program, arguments, reads] = GetParam();
    write_program(programs_, program, hanging(programs_, reads));
    const std::string number = programs_ / "number";
    fs::remove(number);
    return run_program(
        "/bin/sh",
        {"-c", "PATH='" + programs_.path().string() + "':$PATH; cd '" + folder_.path().string() +
                   "'; '" TAUT_PROGRAM "' " + arguments + " & taut=$!; for i in $(seq 1000); do [ -e '" +
                   number + "' ] && break; sleep 0.02; done; sleep 0.1; kill -" + signal +
                   " $taut; wait $taut"},
        {{"TAUT_CACHE", programs_ / "cache"}});
  }
  // Whether the program is gone, soon.
  bool is_gone() const {
    std::string number = read_file(programs_ / "number");
    if (number.empty()) return false;
    number.pop_back();
    for (int i = 0; i < 500 && runs(number); ++i) ::usleep(10000);
    const bool gone = !runs(number);
    if (!gone) ::kill(std::stoi(number), SIGKILL);
    return gone;
  }
  // How many half-made files there are.
  std::size_t half_made() const {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      count += entry.path().extension() == ".part";
    return count;
  }

  TemporaryFolder programs_, folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
};

TEST_P(HangingChild, EndsWithTheFirstSignal) {
  for (const auto& [signal, status] : {std::pair("INT", 130), std::pair("TERM", 143)}) {
    const Ran ran = run_until_hanging(signal);
    EXPECT_EQ(ran.status, status) << ran.err;
    EXPECT_NE(ran.err.find("interrupted"), std::string::npos) << ran.err;
    EXPECT_EQ(ran.err.find("in the middle of a step"), std::string::npos) << ran.err;
    EXPECT_TRUE(is_gone()) << signal;
    EXPECT_EQ(half_made(), 0U) << signal;
  }
}

TEST_P(HangingChild, EndsHoweverTautEnds) {
  for (const char* signal : {"KILL", "HUP"}) {
    run_until_hanging(signal);
    EXPECT_TRUE(is_gone()) << signal;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Programs, HangingChild,
    ::testing::Values(
        Hanging{"FfmpegThatReads", "ffmpeg", "render small.toml --no-frames --size 64x48 --film f.mp4", true},
        Hanging{"FfmpegThatDoesNot", "ffmpeg", "render small.toml --size 640x480 -o frames --film f.mp4",
                false},
        Hanging{"FfmpegIntoAPipe", "ffmpeg", "render small.toml --no-frames --size 640x480 --film -", false},
        Hanging{"GnuplotOfSag", "gnuplot", "sag small.toml --passes 1 --size 64x48 -o sag", true},
        Hanging{"GnuplotOfChart", "gnuplot", "chart small.toml --methods xpbd --budget 0.01s -o chart", true},
        Hanging{
            "GnuplotOfStability", "gnuplot",
            "stability small.toml --axes step,stiffness --grid 2x2 --methods xpbd --duration 0.05 -o maps",
            true}),
    [](const auto& test) { return test.param.name; });

// What a killed run leaves half made goes away with the next one there, and what a living one makes stays.
TEST(Leftovers, GoAwayAtTheNextStart) {
  const TemporaryFolder folder;
  folder.write("small.toml", small_scene());
  const std::string in_folder = "cd '" + folder.path().string() + "'; ";
  const std::string begin =
      "'" TAUT_PROGRAM
      "' still small.toml --set world.duration=3600 --set solve.steps_per_second=100000 "
      "--at 3599 --size 64x48 -o a.png & dead=$!; ";
  const std::string is_there = "for i in $(seq 500); do ls -A | grep -q part && break; sleep 0.02; done; ";
  run_program("/bin/sh", {"-c", in_folder + begin + is_there + "kill -KILL $dead; wait $dead"});
  EXPECT_EQ(folder.entries(), 2U) << "the scene, and what the dead run left";
  const std::string quick = "'" TAUT_PROGRAM "' still small.toml --at 0 --size 64x48 -o b.png || exit 9; ";
  const Ran ran = run_program(
      "/bin/sh",
      {"-c", in_folder + quick + "ls -A | grep -c part; " + begin + is_there + quick +
                 "ls -A | grep -c part; kill -INT $dead; wait $dead; ls -A | grep -c part; exit 0"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "0\n1\n0\n") << ran.err;
}

}  // namespace
}  // namespace taut::testing
