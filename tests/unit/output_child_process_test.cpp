#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/failure.h"
#include "output/child_process.h"

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
