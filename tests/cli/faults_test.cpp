#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

// Each call of the system that a verb writes with fails once, the first, the second and so on, until a run
// makes no further one. See ../faults/failing_calls.cpp.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;

struct Verb {
  std::string name;
  std::string arguments;
  int status = 0;                 // of a run that nothing disturbs
  std::vector<std::string> over;  // files that are there before, and are written over
  int again_every = 1;            // after every how many faults to look at what an undisturbed run makes
};

void PrintTo(const Verb& verb, std::ostream* out) {
  *out << verb.name;
}

using Files = std::map<std::string, std::string>;  // content by name

// All files below a folder.
Files files_in(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder)] = read_file(entry.path());
  return files;
}

// Whether a file's end, by the ending of its name, is that of a whole one.
bool is_whole(const std::string& name, const std::string& content) {
  const std::string ending = fs::path(name).extension();
  if (ending == ".png") return content.size() > 20 && content.ends_with("IEND\xae\x42\x60\x82");
  if (ending == ".svg") return content.find("</svg>") != std::string::npos;
  if (ending == ".json") return nlohmann::json::accept(content);
  if (ending == ".html") return content.find("</html>") != std::string::npos;
  if (ending == ".npz") return content.find("PK\5\6") != std::string::npos;
  if (ending == ".mp4") return content.find("moov") != std::string::npos;
  return ending == ".jsonl" || content.ends_with('\n');
}

// Names of what does not say how long something took or when, and so is the same every time.
bool is_the_same_always(const std::string& name) {
  const std::string ending = fs::path(name).extension();
  return ending == ".mp4" || name.ends_with("cells.csv") || name.ends_with("sag.csv") ||
         name == "table.csv" || ending == ".npz" || ending == ".vtp" ||
         (ending == ".png" && !name.starts_with("chart"));
}

class FaultsTest : public ::testing::TestWithParam<Verb> {
 protected:
  Ran run(const TemporaryFolder& folder, const Environment& disturbance = {}) const {
    Environment environment = disturbance;
    environment.emplace_back("TAUT_CACHE", folder.path() / "cache");
    std::istringstream words(GetParam().arguments);
    return taut({std::istream_iterator<std::string>(words), {}}, environment, folder.path());
  }
  void prepare(const TemporaryFolder& folder) const {
    folder.write("small.toml", small_scene());
    for (const std::string& file : GetParam().over) folder.write(file, before);
  }
  // The number of the call that fails, and as what.
  Ran run_with_fault(const TemporaryFolder& folder, int number, const TemporaryFolder& hit) const {
    constexpr std::array errors{ENOSPC, EIO, EMFILE};
    const int error = errors[static_cast<std::size_t>(number) % errors.size()];
    return run(folder, {{"LD_PRELOAD", TAUT_FAILING_CALLS},
                        {"TAUT_FAULT_AT", std::to_string(number)},
                        {"TAUT_FAULT_ERROR", std::to_string(error)},
                        {"TAUT_FAULT_HIT", hit / "hit"}});
  }
  // All that an undisturbed run makes is there, whole.
  void expect_all(const Files& wanted, const Files& there) const {
    for (const auto& [name, content] : wanted) {
      if (name.starts_with("cache/")) continue;  // what is not kept there is found again
      const auto found = there.find(name);
      ASSERT_NE(found, there.end()) << name;
      EXPECT_TRUE(is_whole(name, found->second)) << name;
      if (is_the_same_always(name)) {
        EXPECT_TRUE(found->second == content) << name;
      }
    }
  }
  // Nothing half made, and what was there before as it was or replaced.
  void expect_whole(const Files& there) const {
    for (const auto& [name, content] : there) {
      EXPECT_FALSE(name.ends_with(".part")) << name;
      EXPECT_TRUE(content == before || is_whole(name, content)) << name;
    }
    for (const std::string& file : GetParam().over) EXPECT_TRUE(there.contains(file)) << file;
  }

  static constexpr const char* before = "what was there before";
};

TEST_P(FaultsTest, EveryCallMayFail) {
  const Verb& verb = GetParam();
  const TemporaryFolder undisturbed;
  prepare(undisturbed);
  const Ran good = run(undisturbed);
  ASSERT_EQ(good.status, verb.status) << good.err;
  const Files wanted = files_in(undisturbed.path());
  int faults = 0;
  for (int number = 1;; ++number) {
    SCOPED_TRACE(::testing::Message() << "call " << number);
    const TemporaryFolder folder, hit;
    prepare(folder);
    const Ran ran = run_with_fault(folder, number, hit);
    const bool was_hit = fs::exists(hit / "hit");
    const Files there = files_in(folder.path());
    if (ran.status == verb.status) {
      expect_all(wanted, there);
    } else {
      EXPECT_EQ(ran.status, 1) << ran.err;
      EXPECT_NE(ran.err.find("taut: "), std::string::npos) << ran.err;
    }
    expect_whole(there);
    if (!was_hit) {
      EXPECT_EQ(ran.status, verb.status) << ran.err;
      break;
    }
    ++faults;
    if (number % verb.again_every == 0) {
      const Ran again = run(folder);
      EXPECT_EQ(again.status, verb.status) << again.err;
      expect_all(wanted, files_in(folder.path()));
    }
    if (HasFailure()) break;
  }
  std::printf("%s: %d faults\n", verb.name.c_str(), faults);
  EXPECT_GT(faults, 3);
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, FaultsTest,
    ::testing::Values(
        Verb{"render", "render small.toml -o frames --film film.mp4 --frames 1-3 --size 64x48", 0, {}, 1},
        Verb{"compare",
             "compare small.toml --methods xpbd,rattle -o both --frames 1-2 --size 64x48",
             0,
             {},
             1},
        Verb{"still", "still small.toml --at 0.5 --size 64x48 -o still.png", 0, {"still.png"}},
        Verb{"strip", "strip small.toml --count 2 --size 64x48 -o strip.png", 0, {"strip.png"}},
        Verb{"export", "export small.toml --times 0.1,0.2,0.3 -o table.csv", 0, {"table.csv"}},
        Verb{"arrays", "export small.toml --times 0.1,0.2,0.3 -o arrays.npz", 0, {"arrays.npz"}},
        Verb{"series", "export small.toml --times 0.1,0.2 --format vtp -o vtp", 0, {}},
        Verb{"sag", "sag small.toml --passes 1 --size 64x48 -o sag", 0, {}, 4},
        Verb{"chart",
             "chart small.toml --methods xpbd --errors energy --budget 0.01s --horizon 0.1s -o chart",
             3,
             {},
             8},
        Verb{"stability",
             "stability small.toml --axes step,stiffness --grid 2x2 --methods xpbd --duration 0.05 -o maps",
             0,
             {},
             4}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace taut::testing
