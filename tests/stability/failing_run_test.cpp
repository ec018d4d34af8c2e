// What a person is told when a run fails or goes off: early, and with steps that would hold.

#include <gtest/gtest.h>

#include <cmath>
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

std::string failure_of(Simulation& simulation, double frames_per_second) {
  try {
    for (int frame = 0; frame < 30.0 * frames_per_second; ++frame) simulation.at(frame / frames_per_second);
  } catch (const RunFailure& failure) {
    return failure.what();
  }
  return {};
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
  const std::string words = "would hold at ";
  const std::size_t at = failure.find(words);
  ASSERT_NE(at, std::string::npos) << failure;
  const double rate = std::stod(failure.substr(at + words.size()));
  EXPECT_GE(rate, 5e5);
  EXPECT_LE(rate, 5.6e5);
}

}  // namespace
}  // namespace taut::test
