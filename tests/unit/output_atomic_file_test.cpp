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
