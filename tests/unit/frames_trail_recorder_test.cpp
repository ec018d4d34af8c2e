#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/failure.h"
#include "frames/simulation.h"
#include "frames/trail_recorder.h"

namespace taut {
namespace {

Scene falling_mass(const std::string& look) {
  return parse_scene(R"(
[world]
duration = 1.0
[solve]
method = "verlet"
steps_per_second = 90
[[mass]]
name = "ball"
position = [0, 2, 0]
velocity = [1, 3, 0]
mass = 1.0
[look]
)" + look,
                     "falling.toml");
}

Trails trails_at(const Scene& scene, const std::vector<double>& times) {
  Simulation simulation(scene);
  std::shared_ptr<const Trails> trails;
  for (const double time : times) trails = simulation.trails(*simulation.at(time));
  return *trails;
}

TEST(TrailRecorder, TrailsAreTheSameWhicheverFramesAreAskedFor) {
  const Scene scene = falling_mass("trails = [\"ball\"]");
  const Trails at_once = trails_at(scene, {0.77});
  const Trails by_and_by = trails_at(scene, {0.1, 0.2, 0.2001, 0.55, 0.77});
  ASSERT_EQ(1U, at_once.size());
  ASSERT_EQ(at_once[0].size(), by_and_by[0].size());
  EXPECT_GT(at_once[0].size(), 100U);
  for (std::size_t i = 0; i < at_once[0].size(); ++i) {
    EXPECT_EQ(at_once[0][i].time, by_and_by[0][i].time);
    EXPECT_EQ(at_once[0][i].place, by_and_by[0][i].place);
    EXPECT_NEAR(at_once[0][i].time, at_once[0][i].place.x(), 1e-9) << "it flies at 1 m/s";
  }
  EXPECT_EQ(0.0, at_once[0].front().time);
  EXPECT_EQ(0.77, at_once[0].back().time);
}

TEST(TrailRecorder, TheRunIsTheSameWithAndWithoutTrails) {
  const Scene with = falling_mass("trails = [\"ball\"]"), without = falling_mass("");
  Simulation one(with), other(without);
  EXPECT_EQ(one.at(0.77)->position.at(0), other.at(0.77)->position.at(0));
  EXPECT_EQ(nullptr, other.trails(*other.at(0.9)));
}

TEST(TrailRecorder, GoesBackAsFarAsAsked) {
  const Trails trails = trails_at(falling_mass("trails = [\"ball\"]\ntrail_time = 0.2"), {0.9});
  EXPECT_LE(trails[0].front().time, 0.7);
  EXPECT_GE(trails[0].front().time, 0.69);
}

TEST(TrailRecorder, ANameOfNoMassIsAnError) {
  try {
    falling_mass("trails = [\"bal\"]");
    FAIL() << "accepted";
  } catch (const std::exception& failure) {
    EXPECT_NE(std::string::npos, std::string(failure.what()).find("did you mean \"ball\"?"))
        << failure.what();
  }
}

}  // namespace
}  // namespace taut
