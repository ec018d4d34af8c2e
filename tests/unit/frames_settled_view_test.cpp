#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "frames/picture_notes.h"
#include "frames/settled_view.h"
#include "frames/simulation.h"
#include "render/camera.h"
#include "render/ground.h"
#include "render/support_reach.h"
#include "scenes_of_the_program.h"

namespace taut {
namespace {

constexpr std::array<Size, 3> shapes{Size{1280, 720}, Size{640, 480}, Size{405, 720}};

Scene settled(Scene scene, Size size) {
  settle_views({&scene, 1}, size);
  return scene;
}

// How far a place is from the edges of the picture, as a share of it; below 0: outside.
double margin_of(const CameraPose& pose, Size size, const Vec3& place) {
  const Vec3 at = picture_position(pose, size.width, size.height, place);
  if (at.z() <= 0.0) return -1.0;
  const double x = at.x() / size.width, y = at.y() / size.height;
  return std::min({x, 1.0 - x, y, 1.0 - y});
}

// The least distance of a mass from an edge of the picture, as a share of it, in all of a scene's frames at
// so many a second; below 0: outside.
double least_margin(const Scene& scene, const std::vector<State>& states, Size size) {
  double least = 1.0;
  for (const State& state : states) {
    const CameraPose pose = camera_pose(scene.camera, scene.model, scene.start, state);
    for (std::size_t i = 0; i < state.position.size(); ++i)
      least = std::min(least, margin_of(pose, size, state.position.at(i)));
  }
  return least;
}

std::vector<State> frames_of(const Scene& scene, int a_second) {
  std::vector<State> states;
  Simulation simulation(scene);
  for (int frame = 0; frame <= scene.duration * a_second; ++frame)
    states.push_back(*simulation.at(std::min(scene.duration, static_cast<double>(frame) / a_second)));
  return states;
}

class EveryScene : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryScene, IsInViewInPicturesOfAnyShape) {
  if (GetParam() == "torn-flag") GTEST_SKIP() << "what is torn off flies away";
  const Scene scene = test::scene_called(GetParam());
  const std::vector<State> states = frames_of(scene, 10);
  for (const Size size : shapes)
    EXPECT_GE(least_margin(settled(scene, size), states, size), 0.05) << size.width << "x" << size.height;
}

INSTANTIATE_TEST_SUITE_P(SettledView, EveryScene, ::testing::ValuesIn(test::scene_names()),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

// The same of what holds a scene's pins, at the start.
double least_margin_of_supports(const Scene& scene, Size size) {
  const SupportReach supports =
      reach_of_supports(scene.model, scene.start, scene.look, up_direction(scene.camera, scene.model));
  const CameraPose pose = camera_pose(scene.camera, scene.model, scene.start, scene.start);
  double least = 1.0;
  for (const Reach& reach : supports.fixed) least = std::min(least, margin_of(pose, size, reach.place));
  for (const auto& [mass, reach] : supports.carried)
    least = std::min(least, margin_of(pose, size, scene.start.position.at(mass) + reach.place));
  return least;
}

TEST_P(EveryScene, IsSeenWithWhatHoldsIt) {
  Scene scene = test::scene_called(GetParam());
  EXPECT_GT(least_margin_of_supports(settled(scene, shapes[0]), shapes[0]), 0.0);
  scene.camera = {};
  for (const Size size : shapes)
    EXPECT_GT(least_margin_of_supports(settled(scene, size), size), 0.02) << size.width << "x" << size.height;
}

// Scenes that say nothing of a camera.
const std::vector<std::string> without_camera{
    // 200 m long, let go level.
    "[world]\nduration = 12\n[[chain]]\nname = \"long\"\nfrom = [0, 250, 0]\nto = [200, 250, 0]\nlinks = 40\n"
    "pinned = [\"first\"]\n",
    // Below height 0.
    "[world]\nduration = 2\n[[chain]]\nname = \"low\"\nfrom = [0, -3, 0]\nto = [1, -3, 0]\nlinks = 10\n"
    "pinned = [\"first\"]\n",
    // A hand's breadth across.
    "[world]\nduration = 1\n[[sheet]]\nname = \"net\"\nrows = 6\ncolumns = 6\nfrom = [0, 1, 0]\n"
    "to = [0.1, 1, 0]\ndown = [0, 0, 0.1]\npinned = [\"top\"]\n",
    // Falls away.
    "[world]\nduration = 1.5\n[[mass]]\nname = \"stone\"\nposition = [0, 2, 0]\nvelocity = [3, 4, 0]\n",
    // Up is along x.
    "[world]\nduration = 2\ngravity = [-9.81, 0, 0]\n[[chain]]\nname = \"rope\"\nfrom = [3, 0, 0]\n"
    "to = [3, 1, 0]\nlinks = 10\npinned = [\"first\"]\n",
    // Driven far away.
    "[world]\nduration = 3\n[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [0, 1, 0]\nlinks = 8\n"
    "pinned = [\"first\"]\nfirst_motion = { path = [[0, 0, 2, 0], [2, 9, 2, 3]] }\n"};

TEST(SettledView, KeepsScenesWithoutACameraInView) {
  for (const std::string& text : without_camera) {
    const Scene scene = parse_scene("[solve]\nmethod = \"xpbd\"\n" + text, "case.toml");
    const std::vector<State> states = frames_of(scene, 20);
    for (const Size size : shapes) {
      const Scene seen = settled(scene, size);
      EXPECT_GE(least_margin(seen, states, size), 0.05) << text;
      // Neither is it lost in the distance.
      const CameraPose pose = camera_pose(seen.camera, seen.model, seen.start, seen.start);
      Vec3 low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);
      for (const State& state : states)
        for (std::size_t i = 0; i < state.position.size(); ++i) {
          const Vec3 at = picture_position(pose, size.width, size.height, state.position.at(i));
          low = low.cwiseMin(at);
          high = high.cwiseMax(at);
        }
      const double filled = std::max((high.x() - low.x()) / size.width, (high.y() - low.y()) / size.height);
      EXPECT_GT(filled, 0.6) << text;
    }
  }
}

TEST(SettledView, PutsTheDrawnGroundBelowTheLowestMass) {
  const Scene low = settled(parse_scene(without_camera[1], "low.toml"), shapes[0]);
  const auto height = [](const Scene& scene) {
    return drawn_grounds(scene.model, scene.look, Vec3::UnitY()).front().point.y();
  };
  EXPECT_LT(height(low), -4.0);
  EXPECT_GT(height(low), -4.5);
  EXPECT_EQ(
      height(settled(parse_scene(without_camera[1] + "[look]\nground_height = -1\n", "low.toml"), shapes[0])),
      -1.0);
  EXPECT_EQ(height(settled(parse_scene(without_camera[1] + "[[plane]]\n", "low.toml"), shapes[0])), 0.0);
  EXPECT_EQ(height(settled(parse_scene(without_camera[2], "net.toml"), shapes[0])), 0.0);
  // With a camera of its own, too.
  EXPECT_LT(height(settled(parse_scene(without_camera[1] + "[camera]\neye = [0, 0, 9]\ntarget = [0, -3, 0]\n",
                                       "low.toml"),
                           shapes[0])),
            -4.0);
}

TEST(SettledView, KeepsAnOrbitingAndAFollowingCameraInView) {
  const std::array<std::string, 3> cameras{"orbit = 120", "follow = \"long.40\"",
                                           "orbit = -90\nshow = [[-200, 40, -10], [200, 250, 10]]"};
  for (const std::string& camera : cameras) {
    const Scene scene = parse_scene(
        "[solve]\nmethod = \"xpbd\"\n" + without_camera[0] + "[camera]\n" + camera + "\n", "long.toml");
    const std::vector<State> states = frames_of(scene, 10);
    for (const Size size : shapes)
      EXPECT_GE(least_margin(settled(scene, size), states, size), 0.05) << camera;
  }
}

TEST(SettledView, LeavesAGivenEyeAndWidensWhatNarrowPicturesSee) {
  const std::string camera = "[camera]\neye = [1, 2, 9]\ntarget = [0, 1, 0]\n";
  const Scene scene = parse_scene(without_camera[2] + camera, "net.toml");
  for (const Size size : shapes) {
    const Scene seen = settled(scene, size);
    EXPECT_EQ(*seen.camera.eye, Vec3(1, 2, 9));
    EXPECT_EQ(*seen.camera.target, Vec3(0, 1, 0));
    const double slope = std::tan(seen.camera.field_of_view / 360.0 * 3.141592653589793);
    EXPECT_NEAR(slope * size.width / size.height, std::tan(19.0 / 180.0 * 3.141592653589793) * 16.0 / 9.0,
                1e-9);
  }
}

TEST(PictureNotes, SayHowManyMassesAreOutside) {
  const auto note = [](const std::string& camera) {
    const Scene scene = settled(
        parse_scene("[solve]\nmethod = \"xpbd\"\n" + without_camera[2] + camera, "net.toml"), shapes[0]);
    PictureNotes notes;
    for (const State& state : frames_of(scene, 5)) notes.see(scene, shapes[0], true, state);
    return notes.text().value_or("");
  };
  EXPECT_EQ(note(""), "");
  EXPECT_NE(note("[camera]\neye = [0, 1, 1]\ntarget = [0, 1, 2]\n").find("nothing is in view"),
            std::string::npos);
  const std::string some = note("[camera]\neye = [0.05, 1, 0.2]\ntarget = [0.05, 1, 0]\n");
  EXPECT_NE(some.find("of 36 masses are outside the picture"), std::string::npos) << some;
}

}  // namespace
}  // namespace taut
