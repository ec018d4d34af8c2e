#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/failure.h"
#include "frames/frame_selection.h"
#include "frames/simulation.h"

namespace taut {
namespace {

// A mass thrown upwards, far from anything.
Scene thrown_mass(const std::string& method) {
  return parse_scene(R"(
[world]
duration = 1.0
[solve]
method = ")" + method + R"("
steps_per_second = 50
[[mass]]
name = "ball"
position = [0, 0, 0]
velocity = [1, 3, 0]
mass = 1.0
[[mass]]
name = "nail"
position = [0, 9, 0]
pinned = true
[[mass]]
name = "bob"
position = [0, 8, 0]
mass = 1.0
[[link]]
a = "nail"
b = "bob"
)",
                     "thrown.toml");
}

TEST(Simulation, BetweenTwoStepsIsOnTheParabola) {
  const Scene scene = thrown_mass("xpbd");
  Simulation simulation(scene);
  // At the steps the scheme is on its own way, at most g·h·t/2 off the parabola; between two of them a frame
  // may add no more than the difference over a step does.
  for (const double time : {0.0, 0.013, 0.02, 0.031, 0.5, 0.777}) {
    const State state = *simulation.at(time);
    const double scheme_error = 0.5 * 9.81 * 0.02 * time + 0.5 * 9.81 * 0.02 * 0.02;
    EXPECT_EQ(state.time, time);
    EXPECT_NEAR(state.position.x[0], time, 1e-12) << time;
    EXPECT_NEAR(state.position.y[0], 3.0 * time - 0.5 * 9.81 * time * time, scheme_error) << time;
  }
}

TEST(Simulation, StepsAreAtExactTimes) {
  const Scene scene = thrown_mass("xpbd");
  Simulation simulation(scene);
  EXPECT_EQ(simulation.at(0.7)->time, 35.0 / 50.0);
  EXPECT_EQ(simulation.steps(), 35);
  EXPECT_EQ(simulation.at(0.71)->time, 0.71);
  EXPECT_EQ(simulation.steps(), 36) << "a time in between needs the step after it";
}

TEST(Simulation, IsNotChangedByWhatIsAskedOfIt) {
  const Scene scene = thrown_mass("xpbd");
  Simulation often(scene), once(scene);
  for (int frame = 1; frame <= 240; ++frame) often.at(frame_time(frame, {2413, 10}));
  EXPECT_EQ(state_hash(*often.at(1.0)), state_hash(*once.at(1.0)));
}

TEST(Simulation, ShowsTheSameAtOneTimeForAnyFrameRate) {
  const Scene scene = thrown_mass("xpbd");
  Simulation slow(scene), fast(scene);
  std::vector<std::uint64_t> every_fifth;
  for (int frame = 1; frame <= 150; ++frame) {
    const std::uint64_t hash = state_hash(*fast.at(frame_time(frame, {150})));
    if (frame % 5 == 1) every_fifth.push_back(hash);
  }
  for (int frame = 1; frame <= 30; ++frame)
    EXPECT_EQ(state_hash(*slow.at(frame_time(frame, {30}))), every_fifth[static_cast<std::size_t>(frame - 1)])
        << frame;
}

TEST(Simulation, StopsWhenToldTo) {
  const Scene scene = thrown_mass("xpbd");
  Simulation simulation(scene);
  EXPECT_FALSE(simulation.at(1.0, [&] { return simulation.steps() == 10; }));
  EXPECT_EQ(simulation.steps(), 10);
}

TEST(Simulation, AFailedStepIsToldInWords) {
  Scene scene = thrown_mass("xpbd");
  scene.model.gravity = Vec3(0.0, -1e300, 0.0);
  Simulation simulation(scene);
  try {
    simulation.at(1.0);
    FAIL() << "it went on";
  } catch (const RunFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("xpbd"), std::string::npos) << failure.what();
  }
}

}  // namespace
}  // namespace taut
