#include <gtest/gtest.h>

#include <string>

#include "base/failure.h"
#include "output/atomic_file.h"
#include "temporary_folder.h"

namespace taut {
namespace {

using testing::read_file;
using testing::TemporaryFolder;

TEST(WriteFile, ReplacesWhatWasThereAndLeavesNothingElse) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "long before");
  write_file(folder / "a.txt", "after");
  EXPECT_EQ(read_file(folder / "a.txt"), "after");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(PendingFile, IsNotThereUntilItIsCommitted) {
  const TemporaryFolder folder;
  {
    PendingFile file(folder / "a.txt");
    file.write(std::as_bytes(std::span("half", 4)));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    EXPECT_EQ(folder.entries(), 1U);
  }
  EXPECT_EQ(folder.entries(), 0U) << "an abandoned file goes away";
}

TEST(PendingFile, LeavesWhatWasThereWhenAbandoned) {
  const TemporaryFolder folder;
  folder.write("a.txt", "before");
  { PendingFile file(folder / "a.txt"); }
  EXPECT_EQ(read_file(folder / "a.txt"), "before");
}

// What a call throws, as text.
template <class Call>
std::string failure_of(const Call& call) {
  try {
    call();
  } catch (const RunFailure& failure) {
    return failure.what();
  }
  return "no failure";
}

TEST(WriteFile, SaysWhyItCannot) {
  const TemporaryFolder folder;
  EXPECT_EQ(failure_of([&] { write_file(folder / "none/a.txt", "x"); }),
            "can't write " + (folder / "none/a.txt") + ": No such file or directory");
}

TEST(PendingFile, SaysWhyItCannotBeCommitted) {
  const TemporaryFolder folder;
  PendingFile file(folder / "a.txt");
  std::filesystem::remove(file.temporary_name());
  EXPECT_EQ(failure_of([&] { file.commit(); }),
            "can't write " + (folder / "a.txt") + ": No such file or directory");
}

TEST(PendingFile, CanBeginAnew) {
  const TemporaryFolder folder;
  PendingFile file(folder / "a.txt");
  file.write(std::as_bytes(std::span("a long beginning", 16)));
  file.replace("short");
  file.commit();
  EXPECT_EQ(read_file(folder / "a.txt"), "short");
}

// What is there of a run that was killed, and of one that lives.
TEST(SweepLeftovers, TakesThoseOfTheDeadOnly) {
  const TemporaryFolder folder;
  folder.write(".a.txt.4711.part", "half");
  const std::string ours = folder.write(".a.txt", "x"), other = folder.write(".a.part", "x");
  const std::string foreign = folder.write("a.txt.4711.part", "x");
  std::filesystem::create_directory(folder / ".folder.1.part");
  PendingFile living(folder / "b.txt");
  sweep_leftovers(folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder / ".a.txt.4711.part"));
  for (const std::string& file : {ours, other, foreign}) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_TRUE(std::filesystem::exists(folder / ".folder.1.part"));
  EXPECT_TRUE(std::filesystem::exists(living.temporary_name()));
  living.commit();
  EXPECT_TRUE(std::filesystem::exists(folder / "b.txt"));
}

TEST(SweepLeftovers, IsDoneWhereAFolderIsMadeReady) {
  const TemporaryFolder folder;
  folder.write(".a.txt.4711.part", "half");
  make_folder(folder.path());
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(SweepLeftovers, IsContentWithNoFolder) {
  const TemporaryFolder folder;
  sweep_leftovers(folder / "none");
  sweep_leftovers(folder.write("file", ""));
}

TEST(SizeOfFile, SaysWhyItCannot) {
  const TemporaryFolder folder;
  EXPECT_EQ(size_of_file(folder.write("a.txt", "four")), 4U);
  EXPECT_EQ(failure_of([&] { size_of_file(folder / "none"); }),
            "can't read " + (folder / "none") + ": No such file or directory");
}

TEST(RemoveFile, SaysWhyItCannotAndIsContentWithNone) {
  const TemporaryFolder folder;
  remove_file(folder / "none");
  const std::string file = folder.write("file", "");
  EXPECT_EQ(failure_of([&] { remove_file(file + "/below"); }),
            "can't remove " + file + "/below: Not a directory");
}

TEST(MakeFolder, SaysWhyItCannot) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  EXPECT_EQ(failure_of([&] { make_folder(file); }), "can't make the folder " + file + ": Not a directory");
  EXPECT_EQ(failure_of([&] { make_folder(file + "/below"); }),
            "can't make the folder " + file + "/below: Not a directory");
}

TEST(MakeFolder, MakesThoseAboveAndIsContentWithOneThatIsThere) {
  const TemporaryFolder folder;
  make_folder(folder / "a/b/c");
  make_folder(folder / "a/b/c");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b/c"));
}

}  // namespace
}  // namespace taut
