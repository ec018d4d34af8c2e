#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/failure.h"
#include "study/case_store.h"
#include "temporary_folder.h"

namespace taut {
namespace {

using testing::read_file;
using testing::TemporaryFolder;

TEST(CaseStore, KeepsWhatWasSavedAndCountsIt) {
  const TemporaryFolder folder;
  const std::string file = folder / "cases/store.jsonl";
  {
    CaseStore store(file, "abc", false);
    store.add("xpbd 60", R"({"error":0.25,"times":[1.5,2]})");
    store.add("a \"quoted\" key\n", "null");
  }
  const CaseStore store(file, "abc", false);
  EXPECT_EQ(store.result("xpbd 60"), R"({"error":0.25,"times":[1.5,2]})");
  EXPECT_EQ(store.result("a \"quoted\" key\n"), "null");
  const CaseCount count = store.count({"xpbd 60", "xpbd 120", "xpbd 240"});
  EXPECT_EQ(count.completed, 1U);
  EXPECT_EQ(count.planned, 3U);
}

// Whatever byte the writing stopped at, exactly the whole lines are there, and going on ends in the same
// file.
TEST(CaseStore, LosesNothingAndRepeatsNothingWhereverItWasCutOff) {
  const TemporaryFolder folder;
  const std::string file = folder / "store.jsonl";
  const std::vector<std::string> keys{"one", "two", "three"};
  {
    CaseStore store(file, "abc", false);
    for (const std::string& key : keys) store.add(key, R"({"x":1.5})");
  }
  const std::string whole = read_file(file);
  for (std::size_t cut = 0; cut < whole.size(); ++cut) {
    std::filesystem::remove(file);
    folder.write("store.jsonl", whole.substr(0, cut));
    const auto lines = std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(cut), '\n');
    CaseStore store(file, "abc", false);
    EXPECT_EQ(store.results().size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, lines - 1)))
        << cut;
    for (const std::string& key : keys)
      if (!store.has(key)) store.add(key, R"({"x":1.5})");
    EXPECT_EQ(read_file(file), whole) << cut;
  }
}

TEST(CaseStore, NeverMixesInputs) {
  const TemporaryFolder folder;
  const std::string file = folder / "store.jsonl";
  { CaseStore(file, "abc", false).add("one", "1"); }
  const std::string before = read_file(file);
  EXPECT_THROW(CaseStore(file, "abd", false), OutputConflict);
  EXPECT_EQ(read_file(file), before);
  CaseStore store(file, "abd", true);
  EXPECT_TRUE(store.results().empty());
  EXPECT_THROW(CaseStore(file, "abd", false), RunFailure) << "it is in use";
}

TEST(CaseStore, TouchesNoFileOfAnotherKind) {
  const TemporaryFolder folder;
  for (const std::string text : {"my notes", "{\"a\":1}\n", "\n"}) {
    const std::string file = folder.write("notes", text);
    EXPECT_THROW(CaseStore(file, "abc", false), OutputConflict);
    EXPECT_EQ(read_file(file), text);
  }
}

TEST(CaseStore, SaysWhichLineIsDamaged) {
  const TemporaryFolder folder;
  const std::string file = folder / "store.jsonl";
  { CaseStore(file, "abc", false).add("one", "1"); }
  folder.write("store.jsonl", read_file(file) + "rubbish\n");
  try {
    const CaseStore store(file, "abc", false);
    FAIL() << "it was taken";
  } catch (const OutputConflict& conflict) {
    EXPECT_NE(std::string(conflict.what()).find("damaged at line 3"), std::string::npos) << conflict.what();
  }
}

TEST(CaseStore, RefusesACaseThatIsThere) {
  const TemporaryFolder folder;
  CaseStore store(folder / "store.jsonl", "abc", false);
  store.add("one", "1");
  EXPECT_THROW(store.add("one", "1"), std::logic_error);
}

}  // namespace
}  // namespace taut
