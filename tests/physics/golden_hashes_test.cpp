// The state hash of every scene under every method that takes it, after its first steps, against
// tests/golden/state-hashes.txt: so that no change of bits goes unseen. Where one is meant, the commit says
// why, and TAUT_WRITE_GOLDEN=1 writes the file anew. And the same run, saved half-way and gone on with in
// another process.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "fixtures.h"
#include "methods/registry.h"
#include "motion/run.h"
#include "other_process.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

namespace fs = std::filesystem;

const fs::path golden_file = TAUT_TEST_DATA "/golden/state-hashes.txt";

// A line each: scene, method, steps, hash.
std::map<std::string, std::string> read_golden() {
  std::map<std::string, std::string> golden;
  std::ifstream in(golden_file);
  for (std::string line; std::getline(in, line);)
    if (const std::size_t space = line.rfind(' '); !line.starts_with('#') && space != std::string::npos)
      golden[line.substr(0, space)] = line.substr(space + 1);
  return golden;
}

// In the place of the one that was there for the same key, or at the end.
void write_golden(const std::string& key, const std::string& hash) {
  std::vector<std::string> lines;
  std::ifstream in(golden_file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const auto same =
      std::ranges::find_if(lines, [&](const auto& line) { return line.starts_with(key + ' '); });
  (same == lines.end() ? lines.emplace_back() : *same) = key + ' ' + hash;
  std::ofstream out(golden_file);
  for (const std::string& line : lines) out << line << '\n';
}

Settings settings_for(const Scene& scene, const Method& method) {
  return method.name == scene.settings.method ? scene.settings
                                              : complete_settings({std::string(method.name), {}});
}

// As many as cost little: a hundred of small scenes, a few of large ones; limits make direct solves dear.
std::int64_t steps_of(const Scene& scene) {
  const std::size_t size = scene.model.links.size() + 100 * scene.model.limits.size() + 1;
  return std::clamp<std::int64_t>(30'000 / static_cast<std::int64_t>(size), 2, 120);
}

std::string hash_after(Run& run, std::int64_t steps) {
  while (run.steps() < steps && run.step()) {
  }
  return fmt::format("{:016x}{}", state_hash(run.state()), run.ended() ? "-ended" : "");
}

class GoldenHashes : public ::testing::TestWithParam<std::string> {};

TEST_P(GoldenHashes, HoldWithAndWithoutAPauseInAnotherProcess) {
  const Scene scene = scene_called(GetParam());
  const std::map<std::string, std::string> golden = read_golden();
  const bool write = std::getenv("TAUT_WRITE_GOLDEN") != nullptr;
  const std::int64_t steps = steps_of(scene);
  for (const Method& method : all_methods()) {
    SCOPED_TRACE(method.name);
    const Settings settings = settings_for(scene, method);
    if (!refusals(scene.model, scene.start, settings).empty()) continue;
    taut::Run straight(scene.model, scene.start, settings), paused(scene.model, scene.start, settings);
    const std::string hash = hash_after(straight, steps);
    hash_after(paused, steps / 2);
    const std::string saved = to_bytes(paused.save());
    EXPECT_EQ(in_other_process([&] {
                taut::Run resumed(scene.model, scene.start, settings, run_state_from(saved, scene.model));
                return hash_after(resumed, steps);
              }),
              hash);
    const std::string key = fmt::format("{} {} {}", GetParam(), method.name, steps);
    if (write) {
      write_golden(key, hash);
    } else {
      const auto found = golden.find(key);
      ASSERT_NE(found, golden.end()) << "no golden hash of " << key;
      EXPECT_EQ(hash, found->second) << key;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenHashes, ::testing::ValuesIn(scene_names()), case_name);

}  // namespace
}  // namespace taut::test
