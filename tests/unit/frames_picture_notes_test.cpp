#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "frames/picture_notes.h"
#include "render/appearance.h"
#include "render/ground.h"

namespace taut {
namespace {

// A mass on a string, and what else the scene has.
Scene scene_with(const std::string& more) {
  Scene scene = parse_scene(R"(
[[mass]]
name = "nail"
position = [0, 1, 0]
pinned = true
[[mass]]
name = "bob"
position = [0, 0.5, 0]
[[link]]
a = "nail"
b = "bob"
)" + more,
                            "bob.toml");
  if (!scene.camera.eye) scene.camera.eye = Vec3(0, 1, 5);
  scene.camera.target = Vec3(0, 1, 0);
  return scene;
}

std::optional<std::string> note_at(const Scene& scene, const Vec3& bob) {
  State state = scene.start;
  state.time = 1.5;
  state.position.set(1, bob);
  return ground_note(scene, masses_in_view(scene.model, scene.look), state);
}

TEST(GroundNote, SaysHowManyMassesAreBelowAGroundThatStopsNothing) {
  const Scene scene = scene_with("");
  EXPECT_EQ(note_at(scene, {0, 0.5, 0}), std::nullopt);
  EXPECT_EQ(note_at(scene, {0, 0, 0}), std::nullopt) << "on it";
  EXPECT_EQ(
      note_at(scene, {0, -0.1, 0}),
      "at 1.5 s 1 of 2 masses is below the drawn ground at y = 0, which stops nothing: add a [[plane]], "
      "or set look.ground_height or look.ground = false");
}

TEST(GroundNote, IsAboutTheGroundThatIsDrawn) {
  const Vec3 below(0, -0.1, 0);
  EXPECT_EQ(note_at(scene_with("[look]\nground_height = -0.5\n"), below), std::nullopt);
  EXPECT_NE(note_at(scene_with("[look]\nground_height = 0.25\n"), {0, 0.2, 0}).value_or("").find("y = 0.25"),
            std::string::npos);
  EXPECT_EQ(note_at(scene_with("[look]\nground = false\n"), below), std::nullopt);
  EXPECT_EQ(note_at(scene_with("[[plane]]\n"), below), std::nullopt) << "a plane stops it, as its method can";
  EXPECT_EQ(note_at(scene_with("[camera]\neye = [0, -1, 5]\n"), below), std::nullopt)
      << "from below no ground is drawn";
}

TEST(GroundNote, FollowsGravity) {
  const Scene scene = scene_with("[camera]\neye = [0, 5, 1]\n[world]\ngravity = [0, 0, -9.81]\n");
  EXPECT_EQ(note_at(scene, {0, -3, 0}), std::nullopt);
  EXPECT_NE(note_at(scene, {0, 0, -0.1}).value_or("").find("at z = 0,"), std::string::npos);
}

TEST(DrawnGrounds, ArePlanesWhereTheyAreAndLevelOnesWhereTheLookSays) {
  const Scene scene = scene_with(R"(
[[plane]]
point = [0, 0.2, 0]
[[plane]]
point = [1, 0, 0]
normal = [-1, 1, 0]
[look]
ground_height = -0.01
)");
  const std::vector<Ground> grounds = drawn_grounds(scene.model, scene.look, Vec3::UnitY());
  ASSERT_EQ(grounds.size(), 2U);
  EXPECT_TRUE(grounds[0].solid && grounds[1].solid);
  EXPECT_EQ(grounds[0].point, Vec3(0, -0.01, 0));
  EXPECT_EQ(grounds[1].point, Vec3(1, 0, 0));
  EXPECT_NEAR(grounds[1].normal.dot(Vec3(-1, 1, 0)), std::sqrt(2.0), 1e-12);
  Look plain;
  const std::vector<Ground> own = drawn_grounds(scene.model, plain, Vec3::UnitY());
  EXPECT_EQ(own[0].point, Vec3(0, 0.2, 0));
  plain.ground = false;
  EXPECT_TRUE(drawn_grounds(scene.model, plain, Vec3::UnitY()).empty());
}

}  // namespace
}  // namespace taut
