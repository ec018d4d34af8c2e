// The verb `stability`: what it writes, going on, shards, exit statuses.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// A map of two methods, 3 × 4 cells, of a scene that takes no time.
std::vector<std::string> small_map(const std::string& scene, const std::string& output,
                                   const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"stability",    scene,    "--methods", "rattle,xpbd", "--axes",
                                     "step,gravity", "--grid", "3x4",       "--duration",  "0.05s",
                                     "-o",           output,   "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

constexpr const char* map_folder = "out/small/step-gravity";

class StabilityTest : public ::testing::Test {
 protected:
  Ran run(const std::vector<std::string>& more = {}, const Environment& environment = {}) {
    return taut(small_map(scene_, folder_ / "out", more), environment);
  }
  Json maps() const { return Json::parse(read_file(folder_.path() / map_folder / "maps.json")); }
  fs::path file(const std::string& name) const { return folder_.path() / map_folder / name; }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
};

TEST_F(StabilityTest, WritesPicturesTablesAndCounts) {
  const Ran ran = run();
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* name : {"rattle.png", "rattle.svg", "xpbd.png", "xpbd.svg", "overview.png", "overview.svg",
                           "cells.csv", "edges.csv", "maps.json", "overview.txt"})
    EXPECT_GT(fs::file_size(file(name)), 0U) << name;
  const Json json = maps();
  EXPECT_EQ(json["completed"], 6);
  EXPECT_EQ(json["planned"], 6);
  EXPECT_EQ(json["methods"][0]["columns"][0]["cells"].size(), 4U);
  EXPECT_TRUE(read_file(file("cells.csv")).starts_with("method,column,row,fate,"));
}

TEST_F(StabilityTest, KeepsWhatIsThereAndRefusesOtherInputs) {
  ASSERT_EQ(run().status, 0);
  const auto written = fs::last_write_time(file("cases.jsonl"));
  EXPECT_EQ(run({"--resume"}).status, 0);
  EXPECT_EQ(fs::last_write_time(file("cases.jsonl")), written);
  EXPECT_EQ(run({"--set", "world.drag=1"}).status, 4);
  EXPECT_EQ(run({"--set", "world.drag=1", "--overwrite"}).status, 0);
}

TEST_F(StabilityTest, DrawsWhatAnotherBuildHasMade) {
  ASSERT_EQ(run().status, 0);
  const Json whole = maps();
  std::string cases = read_file(file("cases.jsonl"));
  const std::size_t end = cases.find("\"}\n");
  cases.replace(end - 4, 4, "0123");  // the last digits of the build's hash
  std::ofstream(file("cases.jsonl"), std::ios::binary) << cases;
  fs::remove(file("overview.png"));
  EXPECT_EQ(run().status, 4) << "nothing is mixed with it";
  EXPECT_EQ(run({"--draw-only"}).status, 0);
  EXPECT_TRUE(fs::exists(file("overview.png")));
  EXPECT_EQ(maps(), whole);
  EXPECT_EQ(run({"--draw-only", "--set", "world.drag=1"}).status, 4) << "another scene's";
}

TEST_F(StabilityTest, ShardsTogetherAreTheWhole) {
  ASSERT_EQ(run().status, 0);
  const Json whole = maps();
  fs::remove_all(folder_.path() / "out");
  EXPECT_EQ(run({"--shard", "1/2"}).status, 0);
  EXPECT_EQ(run({"--draw-only"}).status, 3) << "half is missing";
  EXPECT_LT(maps()["completed"], maps()["planned"]);
  EXPECT_EQ(run({}, {{"SLURM_ARRAY_TASK_ID", "2"}, {"SLURM_ARRAY_TASK_COUNT", "2"}}).status, 0);
  EXPECT_EQ(run({"--draw-only"}).status, 0);
  EXPECT_EQ(maps(), whole);
}

TEST_F(StabilityTest, AnInterruptedRunGoesOnToTheSameEnd) {
  ASSERT_EQ(run().status, 0);
  const Json whole = maps();
  fs::remove_all(folder_.path() / "out");
  const std::string cases = file("cases.jsonl").string();
  std::string command;
  for (const std::string& argument : small_map(scene_, folder_ / "out")) command += " '" + argument + "'";
  const Ran interrupted =
      run_program("/bin/sh", {"-c", "'" TAUT_PROGRAM "'" + command + " & process=$!; while [ ! -s '" + cases +
                                        "' ]; do sleep 0.002; done; kill -INT $process; wait $process"});
  EXPECT_TRUE(interrupted.status == 130 || interrupted.status == 0) << interrupted.status << interrupted.err;
  EXPECT_EQ(run().status, 0);
  EXPECT_EQ(maps(), whole);
}

TEST_F(StabilityTest, BadUsageWritesNothing) {
  for (const std::vector<std::string>& bad : {std::vector<std::string>{"--axes", "step,mass"},
                                              {"--methods", "ratle"},
                                              {"--grid", "1x9"},
                                              {"--shard", "3/2"},
                                              {"--duration", "0"},
                                              {"--axes", "step,links"},
                                              {"--resume", "--overwrite"}}) {
    const Ran ran = run(bad);
    EXPECT_EQ(ran.status, 2) << bad[0] << " " << ran.err;
    EXPECT_FALSE(fs::exists(folder_.path() / "out")) << bad[0];
  }
}

}  // namespace
}  // namespace taut::testing
