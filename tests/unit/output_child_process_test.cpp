#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "base/failure.h"
#include "output/child_process.h"
#include "temporary_folder.h"

namespace taut {
namespace {

TEST(FindProgram, FindsTheShellAndNothingElse) {
  EXPECT_TRUE(find_program("sh"));
  EXPECT_FALSE(find_program("no-program-has-this-name"));
}

TEST(ChildProcess, ReportsStatusAndLastWords) {
  ChildProcess process("/bin/sh", {"-c", "echo it is broken >&2; exit 3"});
  const ProcessEnd end = process.finish();
  EXPECT_EQ(end.status, 3);
  EXPECT_EQ(end.last_lines, "it is broken\n");
}

TEST(ChildProcess, ReportsASignal) {
  ChildProcess process("/bin/sh", {"-c", "kill -TERM $$"});
  EXPECT_EQ(process.finish().status, 128 + 15);
}

TEST(ChildProcess, GetsAllThatItIsFed) {
  ChildProcess process("/bin/sh", {"-c", "wc -c >&2"});
  const std::vector<std::byte> bytes(3'000'000);
  EXPECT_TRUE(process.feed(bytes));
  const ProcessEnd end = process.finish();
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(std::stoul(end.last_lines), bytes.size());
}

TEST(ChildProcess, ThatReadsNoMoreEndsTheFeedingAndNotUs) {
  ChildProcess process("/bin/sh", {"-c", "exit 1"});
  const std::vector<std::byte> bytes(3'000'000);
  EXPECT_FALSE(process.feed(bytes));
  EXPECT_EQ(process.finish().status, 1);
}

TEST(ChildProcess, ThatSaysALotIsNotHeldUp) {
  ChildProcess process("/bin/sh", {"-c", "head -c 1000000 /dev/zero | tr '\\0' x >&2; echo end >&2"});
  const ProcessEnd end = process.finish();
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.last_lines.size(), 2000U);
  EXPECT_TRUE(end.last_lines.ends_with("xend\n"));
}

TEST(ChildProcess, EndsWithItsObject) {
  { const ChildProcess process("/bin/sh", {"-c", "sleep 600"}); }
  SUCCEED() << "it would have taken ten minutes";
}

TEST(ChildProcess, SaysWhichSignalEndedIt) {
  ChildProcess process("/bin/sh", {"-c", "kill -XFSZ $$; exit 3"});
  EXPECT_EQ(end_text(process.finish()), "it ended with status 3") << "that one is left to the program";
  ChildProcess killed("/bin/sh", {"-c", "kill -KILL $$"});
  EXPECT_EQ(end_text(killed.finish()), "it was ended by the signal \"Killed\"");
}

// A grandchild that holds the pipe which is read until its end.
TEST(ChildProcess, IsNotWaitedForLongerThanItLives) {
  ChildProcess process("/bin/sh", {"-c", "echo first >&2; sleep 600 & exit 3"});
  const ProcessEnd end = process.finish();
  EXPECT_EQ(end.status, 3);
  EXPECT_EQ(end.last_lines, "first\n");
}

TEST(ChildProcess, ThatHangsIsLeftWhenToldToStop) {
  ChildProcess process("/bin/sh", {"-c", "sleep 600"});
  int asked = 0;
  EXPECT_THROW(process.finish([&] { return ++asked > 3; }), Interrupted);
  ChildProcess deaf("/bin/sh", {"-c", "sleep 600"});
  const std::vector<std::byte> much(10'000'000);
  asked = 0;
  EXPECT_THROW(deaf.feed(much, [&] { return ++asked > 10; }), Interrupted);
}

// Whether a process runs: one that has ended and is waited for does not.
bool runs(const std::string& process) {
  const std::string status = testing::read_file("/proc/" + process + "/stat");
  return !status.empty() && status.find(") Z ") == std::string::npos;
}

TEST(ChildProcess, DiesWithAProcessThatIsKilled) {
  const testing::TemporaryFolder folder;
  const std::string file = folder / "child";
  const pid_t parent = ::fork();
  if (parent == 0) {
    const ChildProcess process(
        "/bin/sh", {"-c", "echo $$ >" + file + ".new; mv " + file + ".new " + file + "; exec sleep 600"});
    ::pause();
    std::_Exit(0);
  }
  std::string child;
  for (int i = 0; i < 1000 && child.empty(); ++i, ::usleep(10000)) child = testing::read_file(file);
  ASSERT_FALSE(child.empty());
  child.pop_back();
  EXPECT_TRUE(runs(child));
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  for (int i = 0; i < 1000 && runs(child); ++i) ::usleep(10000);
  EXPECT_FALSE(runs(child));
}

TEST(ChildProcess, SaysWhyItCannotStart) {
  try {
    const ChildProcess process("/no/such/program", {});
    FAIL() << "it started";
  } catch (const RunFailure& failure) {
    EXPECT_STREQ(failure.what(), "can't start /no/such/program: No such file or directory");
  }
}

}  // namespace
}  // namespace taut
