#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "program.h"
#include "program_on_the_path.h"
#include "sanitized.h"

// Too little of something: addresses, handles, bytes of a file or of a disk, or no folder any more.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;

class Scarcity : public ::testing::Test {
 protected:
  // Runs a shell's words in a folder with a small scene; TAUT stands for the program.
  Ran shell(std::string words) const {
    for (std::size_t at = 0; (at = words.find("TAUT", at)) != std::string::npos;)
      words.replace(at, 4, "'" TAUT_PROGRAM "'");
    return run_program("/bin/sh", {"-c", words}, {{"XDG_CACHE_HOME", folder_ / "cache"}}, folder_.path());
  }
  // Done, or failed with a reason; in no case ended by a signal.
  static void expect_done_or_said(const Ran& ran, const std::string& what) {
    EXPECT_TRUE(ran.status == 0 || ran.status == 1 || ran.status == 3)
        << what << ": " << ran.status << ran.err;
    if (ran.status == 1) {
      EXPECT_NE(ran.err.find("taut: "), std::string::npos) << what << ran.err;
    }
  }
  std::size_t half_made() const {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      count += entry.path().extension() == ".part";
    return count;
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
};

const std::string scarce_render =
    "TAUT render small.toml --size 64x48 -o frames --overwrite --frames 1-3 --film film.mp4";
const std::string scarce_still = "TAUT still small.toml --at 0.1 --size 64x48 -o still.png";
const std::string scarce_sag = "TAUT sag small.toml --passes 1 --size 64x48 -o sag";
const std::string scarce_chart =
    "TAUT chart small.toml --methods xpbd --errors energy --budget 0.01s -o chart --overwrite";

TEST_F(Scarcity, OfAddressesIsSaid) {
#ifdef TAUT_SANITIZED
  GTEST_SKIP() << "sanitizers take more addresses than there are to be";
#endif
  // With fewer than the first the system's loader gives up, or what a library does before any line of ours.
  std::size_t failed = 0;
  for (int kilobytes = 230000; kilobytes < 1300000; kilobytes += 105000)
    for (const std::string& words : {scarce_render, scarce_still, scarce_sag, scarce_chart,
                                     std::string("TAUT check small.toml --run")}) {
      const Ran ran = shell("ulimit -c 0; ulimit -v " + std::to_string(kilobytes) + "; exec " + words);
      expect_done_or_said(ran, std::to_string(kilobytes) + " " + words);
      failed += ran.status == 1;
    }
  EXPECT_GT(failed, 0U);
  EXPECT_EQ(half_made(), 0U);
}

// What solves all links of a net together fills in many times what the net itself takes.
TEST_F(Scarcity, OfMemoryForAFactorIsSaidBeforeTheRun) {
#ifdef TAUT_SANITIZED
  GTEST_SKIP() << "sanitizers take more addresses than there are to be";
#endif
  folder_.write("net.toml", R"(
[world]
duration = 0.01
[[sheet]]
name = "net"
rows = 256
columns = 256
from = [0, 2, 0]
to = [2, 2, 0]
down = [0, -2, 0]
pinned = ["top"]
diagonals = true
)");
  const auto run_by = [&](const std::string& method, int kilobytes) {
    return shell("ulimit -v " + std::to_string(kilobytes) +
                 "; exec TAUT export net.toml --times 0.01 -o table.npz --method " + method);
  };
  for (const char* method : {"newton", "rattle", "dop853"})
    for (const int kilobytes : {560'000, 700'000, 900'000}) {
      const Ran ran = run_by(method, kilobytes);
      EXPECT_EQ(ran.status, 2) << method << kilobytes << ran.err;
      EXPECT_NE(ran.err.find("solves all links together"), std::string::npos) << method << ran.err;
      EXPECT_FALSE(fs::exists(folder_ / "table.npz")) << method;
    }
  EXPECT_EQ(run_by("xpbd", 700'000).status, 0);
}

TEST_F(Scarcity, OfHandlesIsSaid) {
  std::size_t failed = 0;
  for (int handles = 12; handles <= 30; handles += 3)
    for (const std::string& words : {scarce_render, scarce_still, scarce_sag, scarce_chart}) {
      const Ran ran = shell("ulimit -n " + std::to_string(handles) + "; exec " + words);
      expect_done_or_said(ran, std::to_string(handles) + " " + words);
      failed += ran.status == 1;
      EXPECT_EQ(half_made(), 0U) << handles << words;
    }
  EXPECT_GT(failed, 0U);
}

// A file may not grow beyond some blocks of 512 bytes: writing then fails, which would end a program
// unprepared.
TEST_F(Scarcity, OfBytesInAFileIsSaid) {
  for (const int blocks : {0, 1, 3}) {
    for (const std::string& words : {scarce_render, scarce_still, scarce_sag, scarce_chart,
                                     std::string("TAUT export small.toml -o table.csv")}) {
      const Ran ran =
          shell("(ulimit -f " + std::to_string(blocks) + "; exec " + words + " 2>&1 >/dev/null) | cat >&2");
      EXPECT_EQ(half_made(), 0U) << blocks << words;
      EXPECT_NE(ran.err.find("File too large"), std::string::npos) << blocks << words << ran.err;
    }
    for (const std::string name : {"still.png", "table.csv", "film.mp4"})
      EXPECT_FALSE(fs::exists(folder_ / name)) << blocks << name;
  }
}

// Whether this process may mount file systems where nobody else sees them.
bool can_mount() {
  return run_program("/bin/sh", {"-c", "unshare -rm mount -t tmpfs none /mnt"}).status == 0;
}

TEST_F(Scarcity, OfRoomOnADiskLeavesNoFilmThatIsCut) {
  if (!can_mount()) GTEST_SKIP() << "no file system can be mounted here";
  fs::create_directory(folder_.path() / "disk");
  int whole = 0, none = 0;
  for (const std::string ending : {"mp4", "webm", "gif", "webp"})
    for (const int kilobytes : {4, 8, 12, 16, 20, 28, 40, 80, 300}) {
      const std::string film = "disk/film." + ending;
      const Ran ran = shell("exec unshare -rm sh -c \"mount -t tmpfs -o size=" + std::to_string(kilobytes) +
                            "k none disk && TAUT render small.toml --size 64x48 --no-frames --film " + film +
                            "; status=\\$?; ls -A disk; exit \\$status\"");
      if (ran.status == 0) {
        ++whole;
        EXPECT_EQ(ran.out, ".film." + ending + ".json\nfilm." + ending + "\n");
      } else {
        ++none;
        EXPECT_EQ(ran.status, 1) << film << ran.err;
        // Frames only stay where there is a checkpoint to go on from: on a slow machine.
        EXPECT_TRUE(ran.out.empty() || ran.out == ".film." + ending + ".frames\n") << film << ran.out;
        // Of what stands beside it, where that had no room.
        EXPECT_TRUE(ran.err.find("could not make " + film) != std::string::npos ||
                    ran.err.find("can't write disk/.film") != std::string::npos)
            << ran.err;
      }
    }
  EXPECT_GT(whole, 4);
  EXPECT_GT(none, 4);
}

TEST_F(Scarcity, OfRoomOnADiskLeavesNoPlotThatIsCut) {
  if (!can_mount()) GTEST_SKIP() << "no file system can be mounted here";
  fs::create_directory(folder_.path() / "sag");
  int failed = 0;
  for (const int kilobytes : {8, 24, 48, 72, 96, 120, 160, 2000}) {
    const Ran ran =
        shell("exec unshare -rm sh -c \"mount -t tmpfs -o size=" + std::to_string(kilobytes) +
              "k none sag && " + scarce_sag +
              "; status=\\$?; tail -q -c 8 sag/*.svg; find sag -name '*.part' -o -empty; exit \\$status\"");
    failed += ran.status == 1;
    EXPECT_TRUE(ran.status == 0 || ran.status == 1) << ran.status << ran.err;
    EXPECT_TRUE(ran.out.empty() || ran.out == "</svg>\n\n") << kilobytes << ran.out;
    EXPECT_TRUE(ran.status == 1 || ran.out == "</svg>\n\n") << kilobytes << ran.out;
  }
  EXPECT_GT(failed, 2);
}

TEST_F(Scarcity, OfAFolderThatMayBeWrittenIsSaid) {
  if (!can_mount()) GTEST_SKIP() << "no file system can be mounted here";
  fs::create_directory(folder_.path() / "fixed");
  for (const std::string words :
       {"render small.toml --size 64x48 -o fixed",
        "render small.toml --size 64x48 --no-frames --film fixed/film.mp4",
        "still small.toml --at 0.1 --size 64x48 -o fixed/still.png", "export small.toml -o fixed/table.csv",
        "sag small.toml --passes 1 --size 64x48 -o fixed",
        "chart small.toml --methods xpbd --budget 0.01s -o fixed"}) {
    const Ran ran =
        shell("exec unshare -rm sh -c \"mount -t tmpfs -o ro none fixed && exec TAUT " + words + "\"");
    EXPECT_EQ(ran.status, 1) << words << ran.err;
    EXPECT_NE(ran.err.find("Read-only file system"), std::string::npos) << words << ran.err;
  }
}

TEST_F(Scarcity, OfAFolderThatVanishesIsSaid) {
  const Ran ran = shell(
      "TAUT render small.toml --set world.duration=3000 --size 64x48 -o frames & taut=$!; while [ ! -e "
      "frames/frame-000003.png ]; do sleep 0.02; done; mv frames gone; wait $taut");
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_NE(ran.err.find("can't write frames"), std::string::npos) << ran.err;
  EXPECT_EQ(half_made(), 0U);
}

}  // namespace
}  // namespace taut::testing
