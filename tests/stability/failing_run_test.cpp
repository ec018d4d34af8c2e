// What a person is told when a run fails or goes off: early, and with steps that would hold.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>

#include "base/failure.h"
#include "frames/simulation.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

// A mass of 1 kg that hangs from a pin on a link of 1 m.
Scene hanging_mass(const Settings& given, std::optional<double> stiffness) {
  Scene scene;
  scene.description = pendulum();
  scene.description.masses[1].position = {0.0, -1.0, 0.0};
  scene.description.links[0].properties.stiffness = stiffness;
  scene.duration = 30.0;
  scene.settings = complete_settings(given);
  Built built = build_valid(scene.description);
  scene.model = built.model;
  scene.start = built.start;
  return scene;
}

std::string failure_of(Simulation& simulation, double frames_per_second, double duration = 30.0) {
  try {
    for (int frame = 0; frame < duration * frames_per_second; ++frame)
      simulation.at(frame / frames_per_second);
  } catch (const RunFailure& failure) {
    return failure.what();
  }
  return {};
}

// The steps per second that an error says hold.
std::optional<double> named_rate(const std::string& failure) {
  const std::string before = "would hold at ";
  const std::size_t at = failure.find(before);
  if (at == std::string::npos) return std::nullopt;
  return std::stod(failure.substr(at + before.size()));
}

// Kept velocities gain m (g t)²/2 while the energy scale is m g l: 10³ of it after √(2000 l/g).
TEST(FailingRun, IsStoppedWhenItsEnergyIsAThousandTimesTheScale) {
  const Scene scene = hanging_mass(settings("euler", 60.0), std::nullopt);
  Simulation simulation(scene);
  const std::string failure = failure_of(simulation, 30.0);
  EXPECT_NE(failure.find("diverges"), std::string::npos) << failure;
  const double time = static_cast<double>(simulation.steps()) / 60.0;
  EXPECT_NEAR(time, std::sqrt(2000.0 / 9.81), 0.1);
  EXPECT_EQ(failure.find("would hold"), std::string::npos) << "no step helps: " << failure;
}

// ω = √(k/m) = 10⁶ rad/s: more than 5·10⁵ steps/s. The guard's 12 halvings of 1/60 s don't get there.
TEST(FailingRun, NamesTheStepAtWhichTheMethodWouldHold) {
  const Scene scene = hanging_mass(settings("spring-explicit", 60.0), 1e12);
  Simulation simulation(scene);
  const std::string failure = failure_of(simulation, 60.0);
  const std::optional<double> rate = named_rate(failure);
  ASSERT_TRUE(rate) << failure;
  EXPECT_GE(*rate, 5e5);
  EXPECT_LE(*rate, 5.6e5);
}

// Scenes whose runs fail for other reasons than a step that is a little too long: whatever step is named
// holds to the end, and what is amiss is said.
struct Failing {
  const char *name, *text, *cause;
};

void PrintTo(const Failing& failing, std::ostream* stream) {
  *stream << failing.name;
}

const std::array failings{
    Failing{"PinsTooFast", R"(
[world]
duration = 2
[solve]
method = "rattle"
steps_per_second = 200
[[chain]]
name = "rope"
from = [0, 2, 0]
to = [1, 2, 0]
links = 20
pinned = ["first"]
first_motion = { amplitude = [0.6, 0, 0], angular_frequency = 60 }
)",
            "the pin rope.0 moves at"},
    Failing{"APinThatJerks", R"(
[world]
duration = 2
[solve]
method = "rattle"
steps_per_second = 30
[[chain]]
name = "rope"
from = [0, 2, 0]
to = [0, 1, 0]
links = 10
pinned = ["first"]
first_motion = { path = [[0, 0, 2, 0], [0.5, 0, 2, 0], [0.55, 3, 2, 0], [2, 3, 2, 0]] }
)",
            "tried to the scene's end"},
    Failing{"WrongLengths", R"(
[world]
duration = 2
[solve]
method = "rattle"
steps_per_second = 600
[[mass]]
name = "nail"
position = [0, 2, 0]
pinned = true
[[mass]]
name = "a"
position = [0.5, 2, 0]
[[mass]]
name = "b"
position = [1, 2.2, 0]
[[link]]
a = "nail"
b = "a"
length = 3
[[link]]
a = "a"
b = "b"
length = 0.001
)",
            "at the start the link a – b is"},
    Failing{"AsLongAsItsGap", R"(
[world]
duration = 2
[solve]
method = "rattle"
steps_per_second = 600
[[chain]]
name = "rope"
from = [0, 2, 0]
to = [1, 2, 0]
links = 10
pinned = ["first", "last"]
)",
            "the links between the pins rope.0 and rope.10 are 1 m long"},
};

class AdviceTest : public ::testing::TestWithParam<Failing> {};

TEST_P(AdviceTest, NamesAStepThatHoldsToTheEndOrTheCause) {
  Scene scene = parse_scene(GetParam().text, "failing.toml");
  Simulation simulation(scene);
  const std::string failure = failure_of(simulation, 30.0, scene.duration);
  ASSERT_NE(failure, "") << "it has to fail";
  EXPECT_NE(failure.find(GetParam().cause), std::string::npos) << failure;
  const std::optional<double> rate = named_rate(failure);
  if (!rate) return;
  scene.settings.values["steps_per_second"] = *rate;
  Simulation better(scene);
  EXPECT_EQ(failure_of(better, 30.0, scene.duration), "") << failure;
}

INSTANTIATE_TEST_SUITE_P(Scenes, AdviceTest, ::testing::ValuesIn(failings),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace taut::test
