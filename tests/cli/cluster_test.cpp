#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

// The script of docs/cluster.md as it stands there.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> frames_in(const fs::path& folder) {
  std::map<std::string, std::string> frames;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".png")
      frames[entry.path().filename().string()] = read_file(entry.path());
  return frames;
}

// Four shards under GNU parallel, stopped half-way and started again.
TEST(Cluster, FramesByGnuParallel) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene() + "[look]\ntrails = [\"bob\"]\n");
  const std::string script = "TAUT='" TAUT_PROGRAM "' bash '" TAUT_SOURCE_DIR
                             "/docs/cluster/frames-parallel.sh' '" +
                             scene + "' 4 '" + (folder / "out") + "' --size 96x64";
  const std::string stopped =
      "setsid sh -c \"" + script + "\" & job=$!; for i in $(seq 500); do ls '" + (folder / "out/frames") +
      "' 2>/dev/null | grep -q 0000 && break; sleep 0.02; done; kill -TERM -- -$job; wait $job";
  EXPECT_NE(run_program("/bin/bash", {"-c", stopped}).status, 0);
  const Ran ran = run_program("/bin/bash", {"-c", script});
  ASSERT_EQ(ran.status, 0) << ran.out << ran.err;
  ASSERT_EQ(taut({"render", scene, "-o", folder / "whole", "--film", folder / "whole.mp4", "--size", "96x64"})
                .status,
            0);
  const auto whole = frames_in(folder / "whole");
  EXPECT_EQ(whole.size(), 30U);
  EXPECT_EQ(frames_in(folder / "out/frames").size(), 30U);
  using nlohmann::json;
  EXPECT_EQ(json::parse(read_file(folder / "whole/manifest.json"))["frames"],
            json::parse(read_file(folder / "out/frames/manifest.json"))["frames"]);
  EXPECT_EQ(taut({"verify", folder / "out/frames"}).status, 0);
}

}  // namespace
}  // namespace taut::testing
