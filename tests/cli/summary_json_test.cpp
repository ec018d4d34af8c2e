#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

// What machines are told: every verb has a summary as JSON on stdout.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

nlohmann::json summary(const Words& words, int status = 0, const fs::path& folder = {}) {
  const Ran ran = taut(words, {}, folder);
  EXPECT_EQ(ran.status, status) << words.front() << ": " << ran.err;
  return nlohmann::json::parse(ran.out, nullptr, false);
}

// The verbs that --help lists, from behind its heading to the next empty line.
std::set<std::string> verbs() {
  const std::string help = taut({"--help"}).out;
  std::istringstream list(help.substr(help.find("Subcommands:\n") + 13));
  std::set<std::string> verbs;
  std::string line, verb;
  std::getline(list, line);
  while (std::getline(list, line) && std::istringstream(line) >> verb) verbs.insert(verb);
  return verbs;
}

TEST(SummaryJson, IsThereForEveryVerb) {
  const std::set<std::string> all = verbs();
  EXPECT_GE(all.size(), 15U);
  for (const std::string& verb : all)
    EXPECT_NE(taut({verb, "--help"}).out.find("--json"), std::string::npos) << verb;
}

TEST(SummaryJson, OfANewScene) {
  const TemporaryFolder folder;
  const nlohmann::json json = summary({"new", "rope", "--json"}, 0, folder.path());
  EXPECT_EQ(json["file"], "rope.toml");
  EXPECT_TRUE(fs::exists(folder / "rope.toml"));
  EXPECT_EQ(json["next"].back(), "taut check rope.toml --explain");
}

TEST(SummaryJson, OfAPlot) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const nlohmann::json json = summary({"plot", scene, "-o", folder / "energy", "--json"});
  EXPECT_TRUE(fs::exists(json["png"].get<std::string>()));
  EXPECT_TRUE(fs::exists(json["svg"].get<std::string>()));
}

TEST(SummaryJson, OfAnExport) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const nlohmann::json json =
      summary({"export", scene, "--times", "0.5,1.0", "-o", folder / "small.npz", "--json"});
  EXPECT_EQ(json["format"], "npz");
  EXPECT_EQ(json["frames"], 2);
  EXPECT_EQ(json["broken_links"], 0);
  const nlohmann::json checked = summary({"check", scene, "--run", "--json"});
  EXPECT_EQ(json["last_state_hash"], checked[0]["state_hash"]) << "the same run, however it is looked at";
  EXPECT_EQ(taut({"export", scene, "--json"}).status, 2) << "two things on one stream";
}

TEST(SummaryJson, OfAMerge) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const auto render = [&](const std::string& shard) {
    EXPECT_EQ(taut({"render", scene, "-o", folder / "parts", "--size", "64x48", "--frames", "1-6", "--shard",
                    shard})
                  .status,
              0);
  };
  render("1/2");
  const nlohmann::json begun = summary({"merge", folder / "parts", "--json"}, 3);
  EXPECT_EQ(begun["frames"]["there"], 3);
  EXPECT_EQ(begun["frames"]["missing"].size(), 27U);
  render("2/2");
  const nlohmann::json json = summary({"merge", folder / "parts", "--json"}, 3);
  EXPECT_EQ(json["frames"]["there"], 6);
  EXPECT_TRUE(json["frames"]["film"].is_null());
  EXPECT_TRUE(json["cases"].empty());
}

}  // namespace
}  // namespace taut::testing
