// Cloth with faces over solids out of meshes: no corner, edge or face of one goes through the other, which is
// judged exactly and by nothing that the program itself uses.

#include "face_scenes.h"
#include "solid_texts.h"

namespace taut::test {
namespace {

using testing::box_surface;
using testing::ring_surface;
using testing::solid_of;

class FacesAndMeshSolids : public ::testing::TestWithParam<std::string> {};

Description cloth_over_solid(const MeshSolidSpec& solid, bool faces) {
  Description description;
  SheetSpec cloth = sheet_around("cloth", {0.03, 0.62, 0.04}, Eigen::Matrix3d::Identity(), 1.2, 8, 0.02);
  cloth.collides = false;
  if (!faces) {
    cloth.faces.reset();
    cloth.radius = 0.01;
  }
  description.sheets = {cloth};
  description.mesh_solids = {solid};
  description.drag = 0.5;
  return description;
}

MeshSolidSpec upright_ring() {
  MeshSolidSpec ring;
  ring.turn = {90.0, 30.0, 0.0};
  ring.friction = 0.8;
  return solid_of(ring_surface(0.4, 0.1, 24, 8), ring);
}

std::size_t most_tangles(const std::string& method, const Description& description, int steps,
                         double& deepest) {
  const Built built = built_for(method, description);
  taut::Run moving(built.model, built.start, settings(method, 600.0, 2));
  std::size_t most = 0;
  while (moving.steps() < steps && moving.step()) {
    if (moving.steps() % 3 == 0)
      most = std::max(most, exact_solid_passes(built.model.colliders[0], built.model, moving.state()));
    if (moving.steps() % 60 == 0)
      deepest = std::max(deepest, deepest_penetration(built.model, moving.state()));
  }
  EXPECT_EQ(moving.failure(), "");
  return most;
}

TEST_P(FacesAndMeshSolids, NothingOfARingShowsThroughTheClothOnIt) {
  double deepest = 0.0;
  EXPECT_EQ(most_tangles(GetParam(), cloth_over_solid(upright_ring(), true), 600, deepest), 0U);
  EXPECT_GT(deepest, 0.0) << "it touches";
  EXPECT_LT(deepest, 0.5 * 0.01);
}

TEST_P(FacesAndMeshSolids, WithoutFacesTheRingShowsThrough) {
  double deepest = 0.0;
  EXPECT_GT(most_tangles(GetParam(), cloth_over_solid(upright_ring(), false), 600, deepest), 0U);
}

TEST_P(FacesAndMeshSolids, NothingOfARingThatMovesAndTurnsShowsThrough) {
  MeshSolidSpec ring = upright_ring();
  ring.moves.motion.path = {{0.0, Vec3::Zero()}, {0.6, Vec3(0.0, 0.5, 0.0)}};
  RotationSpec rotation;
  rotation.axis = {1.0, 0.3, 0.5};
  rotation.rate = 180.0;
  ring.moves.rotation = rotation;
  double deepest = 0.0;
  EXPECT_EQ(most_tangles(GetParam(), cloth_over_solid(ring, true), 420, deepest), 0U);
  EXPECT_LT(deepest, 0.01);
}

// As over the box that it is, but for the order in which contacts are seen to.
TEST_P(FacesAndMeshSolids, ABoxOfFacesHoldsClothAsABox) {
  BoxSpec box;
  box.size = {0.5, 0.5, 0.5};
  box.turn = {20.0, 15.0, 35.0};
  box.friction = 0.6;
  MeshSolidSpec solid;
  solid.turn = box.turn;
  solid.friction = box.friction;
  Description with_mesh = cloth_over_solid(solid_of(box_surface(box.size), solid), true);
  Description with_box = with_mesh;
  with_box.mesh_solids.clear();
  with_box.boxes = {box};
  const State of_box = run(built_for(GetParam(), with_box), settings(GetParam(), 600.0, 2), 0.4),
              of_mesh = run(built_for(GetParam(), with_mesh), settings(GetParam(), 600.0, 2), 0.4);
  EXPECT_LT(position_error(of_box, of_mesh), 1e-3);
}

TEST(FacesAndMeshSolidsStart, AClothThatStartsInOneIsRefusedAsInABox) {
  Description description = cloth_over_solid(upright_ring(), true);
  SheetSpec& cloth = description.sheets[0];
  cloth.from.y() = cloth.to.y() = 0.2;
  const Built in_masses = build(description);
  ASSERT_FALSE(in_masses.problems.empty());
  EXPECT_EQ(in_masses.problems[0].section, "solid");
  // Between its masses.
  cloth.from.y() = cloth.to.y() = 0.496;
  const Built built = build(description);
  ASSERT_FALSE(built.problems.empty());
  EXPECT_EQ(built.problems[0].key, "faces");
  EXPECT_NE(built.problems[0].message.find("[[solid]] number 1"), std::string::npos)
      << built.problems[0].message;
}

INSTANTIATE_TEST_SUITE_P(All, FacesAndMeshSolids, ::testing::ValuesIn(face_methods()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace taut::test
