// Faces against solids: no corner, edge, ball or rod shows through, whether solids stay or move, and what is
// measured is what is.

#include <fmt/format.h>

#include "face_scenes.h"

namespace taut::test {
namespace {

class FacesAndSolids : public ::testing::TestWithParam<std::string> {};

// A coarse cloth falls on a box that stands on a corner, and on a ball smaller than its cells.
Description cloth_over(const BoxSpec& box, bool faces) {
  Description description;
  SheetSpec cloth = sheet_around("cloth", {0.03, 0.75, 0.04}, Eigen::Matrix3d::Identity(), 1.2, 8, 0.02);
  cloth.collides = false;
  if (!faces) {
    cloth.faces.reset();
    cloth.radius = 0.01;
  }
  description.sheets = {cloth};
  description.boxes = {box};
  description.drag = 0.5;
  return description;
}

BoxSpec box_on_its_corner() {
  BoxSpec box;
  box.size = {0.6, 0.6, 0.6};
  box.turn = {45.0, 0.0, 35.26438968};
  box.friction = 1.0;
  return box;
}

TEST_P(FacesAndSolids, NoCornerOfABoxShowsThrough) {
  const BoxSpec box = box_on_its_corner();
  const Built built = built_for(GetParam(), cloth_over(box, true));
  taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 2));
  double deepest = 0.0;
  while (moving.steps() < 900) {
    ASSERT_TRUE(moving.step()) << moving.failure();
    ASSERT_EQ(exact_solid_passes(built.model.colliders[0], built.model, moving.state()), 0U)
        << moving.steps();
    deepest = std::max(deepest, deepest_penetration(built.model, moving.state()));
  }
  EXPECT_LT(deepest, 0.3 * 0.01);
}

// What used to be: masses keep off, faces don't, and nothing is measured.
TEST_P(FacesAndSolids, WithoutFacesACornerShowsThrough) {
  const Built built = built_for(GetParam(), cloth_over(box_on_its_corner(), false));
  taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 2));
  std::size_t through = 0;
  while (moving.steps() < 900 && moving.step())
    through = std::max(through, exact_solid_passes(built.model.colliders[0], built.model, moving.state()));
  EXPECT_GT(through, 0U);
}

TEST_P(FacesAndSolids, NoSmallBallOrRodShowsThrough) {
  Description description = cloth_over(box_on_its_corner(), true);
  description.boxes.clear();
  SphereSpec ball;
  ball.centre = {0.0, 0.3, 0.0};
  ball.radius = 0.03;
  CapsuleSpec rod;
  rod.from = {0.3, -0.4, 0.2};
  rod.to = {0.3, 0.4, 0.2};
  rod.radius = 0.01;
  description.spheres = {ball};
  description.capsules = {rod};
  const Built built = built_for(GetParam(), description);
  taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 2));
  double least = infinity, deepest = 0.0;
  while (moving.steps() < 480) {
    ASSERT_TRUE(moving.step()) << moving.failure();
    for (const Triangle& triangle : built.model.triangles) {
      std::array<Vec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = moving.state().position.at(triangle.masses[k]);
      for (const Collider& collider : built.model.colliders)
        for (int i = 0; i <= 24; ++i)  // places all over the triangle
          for (int j = 0; i + j <= 24; ++j) {
            const Vec3 place =
                corners[0] + (corners[1] - corners[0]) * (i / 24.0) + (corners[2] - corners[0]) * (j / 24.0);
            least = std::min(least, nearest_surface(collider.shape, place).distance);
          }
    }
    deepest = std::max(deepest, deepest_penetration(built.model, moving.state()));
  }
  EXPECT_GT(least, 0.0);
  EXPECT_LT(deepest, 0.01);
  EXPECT_NEAR(least, 0.01 - deepest, 2e-3);  // what is measured is what is
}

// A solid that moves through a held sheet, but for its faces.
Built solid_through_a_sheet(const std::string& method, const BoxSpec* box, const SphereSpec* ball) {
  Description description;
  SheetSpec sheet = sheet_around("sheet", Vec3::Zero(), Eigen::Matrix3d::Identity(), 1.0, 6, 0.02);
  sheet.pinned = {"top-left", "top-right"};
  description.sheets = {sheet};
  description.gravity = {0.0, -1.0, 0.0};
  if (box) description.boxes = {*box};
  if (ball) description.spheres = {*ball};
  return built_for(method, description);
}

// Faster than the ball is wide, from one step to the next.
TEST_P(FacesAndSolids, NoSmallBallThatMovesShootsThrough) {
  for (const double speed : {2.0, 20.0, 60.0}) {
    SphereSpec ball;
    ball.radius = 0.02;
    ball.centre = {0.04, -0.3, 0.07};
    ball.moves.motion.path = {{0.0, ball.centre}, {0.6 / speed, ball.centre + Vec3(0.0, 0.6, 0.0)}};
    const Built built = solid_through_a_sheet(GetParam(), nullptr, &ball);
    taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 2));
    while (moving.state().time < 0.8 / speed) {
      ASSERT_TRUE(moving.step()) << moving.failure();
      for (const Triangle& triangle : built.model.triangles) {
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = moving.state().position.at(triangle.masses[k]);
        ASSERT_GT(least_distance(shape_at(built.model.colliders[0], moving.state().time), corners), 0.0)
            << speed << " m/s, " << moving.state().time << " s";
      }
      // The sheet is taken along: its middle is above the ball, or it has slid off beside.
      const Vec3 centre = std::get<Sphere>(shape_at(built.model.colliders[0], moving.state().time)).centre;
      ASSERT_FALSE(is_above(centre, built.model, moving.state(), built.model.sheets[0]) && centre.y() < 0.0);
    }
    EXPECT_GT(centre_of_mass(built.model, moving.state()).y(), 0.05) << speed;
  }
}

TEST_P(FacesAndSolids, NoCornerOfABoxThatMovesAndTurnsShowsThrough) {
  BoxSpec box;
  box.size = {0.25, 0.25, 0.25};
  box.centre = {0.05, -0.35, 0.02};
  box.moves.motion.path = {{0.0, box.centre}, {0.5, box.centre + Vec3(0.0, 0.6, 0.0)}};
  RotationSpec rotation;
  rotation.axis = {1.0, 0.3, 0.5};
  rotation.rate = 230.0;
  box.moves.rotation = rotation;
  const Built built = solid_through_a_sheet(GetParam(), &box, nullptr);
  taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 2));
  double deepest = 0.0;
  while (moving.steps() < 420) {
    ASSERT_TRUE(moving.step()) << moving.failure();
    ASSERT_EQ(exact_solid_passes(built.model.colliders[0], built.model, moving.state()), 0U)
        << moving.steps();
    deepest = std::max(deepest, deepest_penetration(built.model, moving.state()));
  }
  EXPECT_LT(deepest, 0.01);
}

INSTANTIATE_TEST_SUITE_P(All, FacesAndSolids, ::testing::ValuesIn(face_methods()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace taut::test
