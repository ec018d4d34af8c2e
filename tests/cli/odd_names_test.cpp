#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

// Names of files may hold any byte but / and 0; JSON, and who reads it, knows UTF-8 only.

namespace taut::testing {
namespace {

const std::string no_text = "odd \xff\nname";

TEST(OddNames, AreToldInJsonThatCanBeRead) {
  const TemporaryFolder folder;
  const std::string scene = folder.write(no_text + ".toml", small_scene());
  const std::string bad = folder.write(no_text + "-bad.toml", "[worl]\n");
  const std::string frames = folder / no_text, size = "64x48";
  const std::vector<std::vector<std::string>> commands{
      {"check", scene, "--json"},
      {"check", scene, "--run", "--json"},
      {"check", bad, "--json"},
      {"render", scene, "-o", frames, "--frames", "1-2", "--size", size, "--json"},
      {"render", bad, "--json"},
      {"verify", frames, "--json"},
      {"still", scene, "--at", "0.5", "-o", folder / (no_text + ".png"), "--size", size, "--json"},
      {"strip", scene, "--count", "2", "-o", folder / (no_text + ".png"), "--size", size, "--json"},
      {"simulate", scene, "-o", folder / (no_text + "-motion"), "--json"},
      {"verify", folder / (no_text + "-motion"), "--json"},
  };
  for (const std::vector<std::string>& words : commands) {
    const Ran ran = taut(words);
    EXPECT_TRUE(nlohmann::json::accept(ran.out)) << words.front() << ": " << ran.out << ran.err;
    EXPECT_EQ(ran.err.find("exception"), std::string::npos) << ran.err;
  }
  EXPECT_TRUE(nlohmann::json::accept(read_file(frames + "/manifest.json")));
}

}  // namespace
}  // namespace taut::testing
