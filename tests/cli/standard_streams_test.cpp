#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "program.h"

// What is printed where nothing can be written, and to nobody.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;

// Every way in which each verb prints to standard output. SCENE and FOLDER stand for a small scene and a
// folder.
const std::vector<std::string> that_print{
    "--version",
    "--help",
    "render --help",
    "check SCENE",
    "check SCENE --json",
    "check SCENE --explain",
    "check SCENE --run",
    "list scenes",
    "list scenes --json",
    "list methods",
    "list methods --json",
    "list keys",
    "list gl",
    "export SCENE",
    "export SCENE --times 0.5",
    "render SCENE -o FOLDER/frames --frames 1-2 --size 64x48 --json",
    "render SCENE --no-frames --size 64x48 --film -",
    "render SCENE --no-frames --size 64x48 --film webm:-",
    "render SCENE --no-frames --size 64x48 --film gif:-",
    "compare SCENE --methods xpbd,rattle -o FOLDER/compared --frames 1-2 --size 64x48 --json",
    "still SCENE --at 0.5 --size 64x48 -o FOLDER/still.png --json",
    "strip SCENE --count 2 --size 64x48 -o FOLDER/strip.png --json",
    "sag SCENE --passes 1 --size 64x48 -o FOLDER/sag --json",
    "chart SCENE --methods xpbd --budget 0.01s -o FOLDER/chart --json",
    "stability SCENE --axes step,stiffness --grid 2x2 --methods xpbd --duration 0.05 -o FOLDER/stability "
    "--json",
};

class StandardStreams : public ::testing::Test {
 protected:
  // The exit status of taut, which says `err`, with these redirections of the shell.
  Ran run(const std::string& words, const std::string& redirections) const {
    return shell("'" TAUT_PROGRAM "' " + words + " " + redirections);
  }
  Ran shell(std::string words) const {
    const auto put = [&](const std::string& name, const std::string& value) {
      for (std::size_t at = 0; (at = words.find(name)) != std::string::npos;)
        words.replace(at, name.size(), "'" + value + "'");
    };
    put("SCENE", scene_);
    put("FOLDER", folder_.path().string());
    return run_program("/bin/sh", {"-c", words}, {{"TAUT_CACHE", folder_ / "cache"}});
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
};

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

TEST_F(StandardStreams, WhatCannotBePrintedIsAFailure) {
  for (const std::string& words : that_print)
    for (const std::string redirection : {">/dev/full", ">&-"}) {
      const Ran ran = run(words, redirection);
      EXPECT_EQ(ran.status, 1) << words << redirection << ran.err;
      EXPECT_EQ(count_of(ran.err, "taut: can't write to standard output: ") +
                    count_of(ran.err, "taut: ffmpeg could not make "),
                1U)
          << words << redirection << ran.err;
    }
}

TEST_F(StandardStreams, AReaderThatHasGoneIsAFailure) {
  for (const std::string words :
       {"--version", "list keys", "export SCENE", "render SCENE --no-frames --size 64x48 --film -"}) {
    const Ran ran = shell("{ sleep 0.2; '" TAUT_PROGRAM "' " + words + "; echo $? >FOLDER/status; } | true");
    EXPECT_EQ(read_file(folder_ / "status"), "1\n") << words;
    EXPECT_NE(ran.err.find("Broken pipe"), std::string::npos) << words << ran.err;
  }
}

// Nobody looks, and nothing else changes.
TEST_F(StandardStreams, WhatCannotBeToldIsNoFailure) {
  for (const std::string& words : that_print)
    for (const std::string redirection : {"2>&-", "2>/dev/full", "<&- 2>&-"}) {
      const Ran ran = run(words, redirection);
      const bool incomplete = words.starts_with("chart");
      EXPECT_EQ(ran.status, incomplete ? 3 : 0) << words << redirection;
      EXPECT_NE(ran.out, "") << words << redirection;
    }
  EXPECT_EQ(run("list nothing", "2>&-").status, 2);
  EXPECT_EQ(run("check none.toml", "2>/dev/full").status, 2);
}

// A film would take the place of a stream that is closed, and get what is told.
TEST_F(StandardStreams, NothingThatIsToldGetsIntoAFile) {
  const std::string render = "render SCENE --size 64x48 -o FOLDER/frames --overwrite --film FOLDER/";
  ASSERT_EQ(run(render + "told.webp", "").status, 0);
  for (const std::string closed : {"2>&-", "<&- 2>&-", "<&- >&- 2>&-"}) {
    ASSERT_EQ(run(render + "untold.webp", closed).status, 0);
    EXPECT_EQ(read_file(folder_ / "untold.webp"), read_file(folder_ / "told.webp")) << closed;
  }
}

}  // namespace
}  // namespace taut::testing
