// Solids out of meshes in the picture.

#include <gtest/gtest.h>

#include <cstdlib>

#include "geometry/solid_surface.h"
#include "model/solid_mesh.h"
#include "small_scenes.h"
#include "solid_texts.h"

namespace taut {
namespace {

using testing::ball_surface;
using testing::bare_look;
using testing::box_surface;
using testing::channel_at;
using testing::cut_out;
using testing::draw_once;
using testing::ring_surface;
using testing::solid_of;
using testing::straight_on;

Image picture_of(Description description, const Look& look, double time = 0.0) {
  MassSpec mass;
  mass.name = "far";
  mass.position = {0.0, 0.0, -20.0};
  mass.radius = 0.01;
  description.masses.push_back(mass);
  Built scene = build(description);
  EXPECT_TRUE(scene.problems.empty());
  scene.start.time = time;
  RenderSettings settings = cut_out(testing::size);
  settings.shadow_map_size = 512;
  return draw_once(scene.model, scene.start, look, settings, straight_on());
}

// The share of pixels of which a channel differs by more than so many levels.
double share_that_differs(const Image& a, const Image& b, int levels) {
  int differing = 0;
  for (int y = 0; y < testing::size.height; ++y)
    for (int x = 0; x < testing::size.width; ++x)
      for (int channel = 0; channel < 4; ++channel)
        if (std::abs(channel_at(a, x, y, channel) - channel_at(b, x, y, channel)) > levels) {
          ++differing;
          break;
        }
  return static_cast<double>(differing) / (testing::size.width * testing::size.height);
}

Look lit_look() {
  Look look = bare_look();
  look.shadows = true;
  return look;
}

TEST(DrawnMeshSolids, ABoxOfFacesLooksAsABox) {
  Description with_box, with_mesh;
  BoxSpec box;
  box.size = {1.0, 0.7, 0.5};
  box.turn = {25.0, 35.0, 10.0};
  with_box.boxes = {box};
  MeshSolidSpec solid;
  solid.turn = box.turn;
  with_mesh.mesh_solids = {solid_of(box_surface(box.size), solid)};
  EXPECT_LE(share_that_differs(picture_of(with_box, lit_look()), picture_of(with_mesh, lit_look()), 2), 2e-3);
}

// Smooth over its edges, so that facets are not seen.
TEST(DrawnMeshSolids, ABallOfFacesLooksAsABall) {
  Description with_ball, with_mesh, with_facets;
  SphereSpec ball;
  ball.radius = 0.8;
  with_ball.spheres = {ball};
  with_mesh.mesh_solids = {solid_of(ball_surface(0.8, 4))};
  with_facets.mesh_solids = {solid_of(ball_surface(0.8, 0))};
  const Image expected = picture_of(with_ball, lit_look());
  EXPECT_LE(share_that_differs(expected, picture_of(with_mesh, lit_look()), 3), 0.01);
  EXPECT_GE(share_that_differs(expected, picture_of(with_facets, lit_look()), 3), 0.05);
}

TEST(DrawnMeshSolids, NormalsAreSmoothOverFlatEdgesAndCreasedOverSharpOnes) {
  const SolidSurface ball = solid_surface(*testing::shape_of(ball_surface(1.0, 2)).mesh);
  EXPECT_EQ(ball.vertices.size(), 162U);
  for (const SolidVertex& vertex : ball.vertices)
    EXPECT_GT(glm::dot(glm::normalize(vertex.position), vertex.normal), 0.999F);
  const SolidSurface box = solid_surface(*testing::shape_of(box_surface({1.0, 2.0, 3.0})).mesh);
  EXPECT_EQ(box.vertices.size(), 24U);
  for (const SolidVertex& vertex : box.vertices)
    EXPECT_NEAR(glm::dot(glm::abs(vertex.normal), glm::vec3(1.0F)), 1.0F, 1e-6F) << "along an axis";
}

TEST(DrawnMeshSolids, ARingHasAHoleAndTurns) {
  Description description;
  MeshSolidSpec ring;
  ring.turn = {90.0, 0.0, 0.0};
  RotationSpec rotation;
  rotation.axis = {0.0, 1.0, 0.0};
  rotation.rate = 90.0;
  ring.moves.rotation = rotation;
  description.mesh_solids = {solid_of(ring_surface(0.7, 0.2, 48, 16), ring)};
  const int middle_x = testing::size.width / 2, middle_y = testing::size.height / 2;
  const double metre = testing::size.height / (2.0 * 5.0 * std::tan(19.0 * std::numbers::pi / 180.0));
  const int side = static_cast<int>(0.7 * metre);
  const Image facing = picture_of(description, bare_look());
  EXPECT_EQ(channel_at(facing, middle_x, middle_y, 3), 0);
  EXPECT_EQ(channel_at(facing, middle_x + side, middle_y, 3), 255);
  const Image edge_on = picture_of(description, bare_look(), 1.0);
  EXPECT_EQ(channel_at(edge_on, middle_x, middle_y, 3), 255);
  EXPECT_EQ(channel_at(edge_on, middle_x + side, middle_y, 3), 0);
}

// Its back is in the shade of its front, as that of a thing of its thickness.
TEST(DrawnMeshSolids, AMeshThrowsAShadow) {
  Description description;
  MeshSolidSpec roof;
  roof.position = {0.3, 1.4, 0.9};  // towards the light, out of the picture
  description.mesh_solids = {solid_of(box_surface({1.5, 0.05, 1.5}), roof),
                             solid_of(box_surface({1.0, 0.4, 0.4}))};
  Description alone = description;
  alone.mesh_solids.erase(alone.mesh_solids.begin());
  const int x = testing::size.width / 2, y = testing::size.height / 2;
  EXPECT_LT(channel_at(picture_of(description, lit_look()), x, y, 1) + 20,
            channel_at(picture_of(alone, lit_look()), x, y, 1));
}

TEST(DrawnMeshSolids, AreHiddenAndColouredAsTheirObjectSays) {
  Description description;
  description.mesh_solids = {solid_of(box_surface({1.0, 0.5, 0.5}))};
  Look look = bare_look();
  look.objects.mesh_solids.resize(1);
  look.objects.mesh_solids[0].colour = Colour{1.0, 0.0, 0.0};
  const int x = testing::size.width / 2, y = testing::size.height / 2;
  const Image red = picture_of(description, look);
  EXPECT_GT(channel_at(red, x, y, 0), channel_at(red, x, y, 1) + 60);
  look.objects.mesh_solids[0].visible = false;
  EXPECT_EQ(channel_at(picture_of(description, look), x, y, 3), 0);
}

}  // namespace
}  // namespace taut
