// Every scene that comes with the program does what it says in [expect].

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "frames/simulation.h"
#include "measure/expectation.h"
#include "scene/scene.h"

namespace taut::test {
namespace {

std::vector<std::string> scene_names() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(TAUT_SCENE_FOLDER))
    if (entry.path().extension() == ".toml") names.insert(entry.path().stem().string());
  return {names.begin(), names.end()};
}

std::string scene_case(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& letter : name)
    if (letter == '-') letter = '_';
  return name;
}

class Scenes : public ::testing::TestWithParam<std::string> {};

TEST_P(Scenes, EndAsTheyExpect) {
  const Scene scene = load_scene(std::filesystem::path(TAUT_SCENE_FOLDER) / (GetParam() + ".toml"));
  Simulation simulation(scene);
  const std::optional<State> end = simulation.at(scene.duration);
  ASSERT_TRUE(end);
  const auto findings = check_expectation(scene.expectation, scene.model, *end, simulation.measures(*end));
  EXPECT_FALSE(findings.empty()) << "a scene says what must hold at its end";
  for (const Finding& finding : findings) EXPECT_TRUE(finding.holds) << finding.key << ": " << finding.text;
}

INSTANTIATE_TEST_SUITE_P(Folder, Scenes, ::testing::ValuesIn(scene_names()), scene_case);

}  // namespace
}  // namespace taut::test
