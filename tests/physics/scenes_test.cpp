// Every scene that comes with the program does what it says in [expect].

#include <gtest/gtest.h>

#include "fixtures.h"
#include "frames/simulation.h"
#include "measure/expectation.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

class Scenes : public ::testing::TestWithParam<std::string> {};

TEST_P(Scenes, EndAsTheyExpect) {
  const Scene scene = scene_called(GetParam());
  Simulation simulation(scene);
  const std::optional<State> end = simulation.at(scene.duration);
  ASSERT_TRUE(end);
  const auto findings = check_expectation(scene.expectation, scene.model, *end, simulation.measures(*end));
  EXPECT_FALSE(findings.empty()) << "a scene says what must hold at its end";
  for (const Finding& finding : findings) EXPECT_TRUE(finding.holds) << finding.key << ": " << finding.text;
}

INSTANTIATE_TEST_SUITE_P(Folder, Scenes, ::testing::ValuesIn(scene_names()), case_name);

}  // namespace
}  // namespace taut::test
