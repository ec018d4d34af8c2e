// Solids out of mesh files: what is made of them, what is mended, and what is refused with which words.

#include <gtest/gtest.h>

#include "model/colliders.h"
#include "solid_texts.h"

namespace taut::testing {
namespace {

double distance_at(const SolidReading& reading, const Vec3& place) {
  return reading.data->mesh->nearest(place - reading.data->middle).distance;
}

TEST(SolidFilesRead, IsPlacedAsClothIs) {
  MeshSolidSpec spec;
  spec.scale = 0.001;
  spec.up = UpAxis::z;
  spec.position = {1.0, 2.0, 3.0};
  spec.turn = {0.0, 90.0, 0.0};
  const SolidReading reading = SolidFiles().read("a.obj", box_surface({200.0, 400.0, 600.0}).obj(), spec);
  // 0.2 along x, 0.6 up, 0.4 away; then a quarter of a turn about the vertical.
  EXPECT_NEAR(distance_at(reading, {1.0, 2.3, 3.0}), 0.0, 1e-12);
  EXPECT_NEAR(distance_at(reading, {1.2, 2.0, 3.0}), 0.0, 1e-12);
  EXPECT_NEAR(distance_at(reading, {1.0, 2.0, 3.1}), 0.0, 1e-12);
  EXPECT_TRUE(reading.notes.empty());
}

TEST(SolidFilesRead, FacesThatLookInwardsAreTurnedOver) {
  Surfaces inwards;
  inwards.add(box_surface({1.0, 1.0, 1.0}), Vec3::Zero(), true);
  const SolidReading reading = SolidFiles().read("a.obj", inwards.obj());
  EXPECT_NEAR(distance_at(reading, Vec3::Zero()), -0.5, 1e-12);
  ASSERT_EQ(reading.notes.size(), 1U);
  EXPECT_EQ(reading.notes[0], "a.obj: its faces looked inwards, and were turned over");
}

TEST(SolidFilesRead, APieceWithinAnotherIsAHollowWhicheverWayItLooks) {
  for (const bool turned_over : {false, true}) {
    Surfaces hollow = box_surface({1.0, 1.0, 1.0});
    hollow.add(box_surface({0.6, 0.6, 0.6}), Vec3::Zero(), turned_over);
    hollow.add(box_surface({0.2, 0.2, 0.2}), Vec3::Zero());
    const SolidReading reading = SolidFiles().read("a.obj", hollow.obj());
    EXPECT_NEAR(distance_at(reading, {0.4, 0.0, 0.0}), -0.1, 1e-12) << "in the wall";
    EXPECT_NEAR(distance_at(reading, {0.25, 0.0, 0.0}), 0.05, 1e-12) << "in the hollow";
    EXPECT_NEAR(distance_at(reading, Vec3::Zero()), -0.1, 1e-12) << "in what is in it";
    EXPECT_EQ(reading.notes.size(), turned_over ? 0U : 1U);
  }
}

TEST(SolidFilesRead, RefusesAnOpenSurfaceByItsFirstOpenFace) {
  Surfaces open = box_surface({1.0, 1.0, 1.0});
  open.faces.erase(open.faces.begin() + 3);
  EXPECT_EQ(
      SolidFiles().error("a.obj", open.obj()),
      "a.obj:9: the surface is open, and a solid's is closed: the face has no neighbour at its edge from "
      "(-0.5, 0.5, 0.5) to (-0.5, 0.5, -0.5) in the file, and there are 4 such edges; \"weld\" joins "
      "corners that are near");
  EXPECT_EQ(SolidFiles().error("a.obj", square_obj).substr(0, 31), "a.obj:6: the surface is open, a");
}

TEST(SolidFilesRead, RefusesThreeFacesAtAnEdge) {
  Surfaces fin = box_surface({1.0, 1.0, 1.0});
  fin.vertices.emplace_back(0.0, 2.0, 0.0);
  fin.faces.push_back({2, 3, 8});
  const std::string error = SolidFiles().error("a.obj", fin.obj());
  EXPECT_EQ(error.substr(0, 80),
            "a.obj:16: three faces meet at one edge, and a solid's surface has two at each: t");
}

TEST(SolidFilesRead, RefusesASurfaceThatGoesThroughItself) {
  Surfaces two = box_surface({1.0, 1.0, 1.0});
  two.add(box_surface({1.0, 1.0, 1.0}), {0.5, 0.4, 0.3});
  EXPECT_NE(SolidFiles()
                .error("a.obj", two.obj())
                .find("the surface goes through itself, and so what is inside is in doubt: this face and "
                      "that of line"),
            std::string::npos)
      << SolidFiles().error("a.obj", two.obj());
}

TEST(SolidFilesRead, RefusesASurfaceWithoutVolume) {
  const std::string error = SolidFiles().error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n");
  EXPECT_EQ(error, "a.obj:4: there is no volume in this surface: its faces lie on one another");
}

// Two boxes, a corner of the one at a corner of the other.
TEST(SolidFilesRead, RefusesPartsThatTouchAtACorner) {
  Surfaces two = box_surface({1.0, 1.0, 1.0});
  two.add(box_surface({1.0, 1.0, 1.0}), {1.0, 1.0, 1.0});
  EXPECT_NE(SolidFiles().error("a.obj", two.obj()).find("touch at a corner of this face alone"),
            std::string::npos)
      << SolidFiles().error("a.obj", two.obj());
}

// A Klein bottle's figure of eight: closed, with one side.
TEST(SolidFilesRead, RefusesASurfaceWithOneSide) {
  Surfaces bottle;
  const std::size_t around = 24, across = 12;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * static_cast<double>(i) / around,
                   v = 2.0 * std::numbers::pi * (static_cast<double>(j) + 0.5) / across;
      const double out = 2.0 + std::cos(0.5 * u) * std::sin(v) - std::sin(0.5 * u) * std::sin(2.0 * v);
      bottle.vertices.emplace_back(out * std::cos(u),
                                   std::sin(0.5 * u) * std::sin(v) + std::cos(0.5 * u) * std::sin(2.0 * v),
                                   out * std::sin(u));
      // Once around, what was above is below.
      const auto at = [&](std::size_t row, std::size_t column) {
        return row < around ? row * across + column % across : (across - 1 - column % across);
      };
      bottle.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  EXPECT_NE(SolidFiles().error("a.obj", bottle.obj()).find("the surface has one side only"),
            std::string::npos)
      << SolidFiles().error("a.obj", bottle.obj());
}

TEST(SolidFilesRead, RefusesAFileWithoutFaces) {
  EXPECT_EQ(SolidFiles().error("a.obj", "v 0 0 0\n"),
            "a.obj: there are no faces in it, and a solid is made of those");
}

// An STL file has each corner as often as there are facets around it.
TEST(SolidFilesRead, WeldsWhatAnStlFileHasSeveralTimes) {
  const Surfaces ball = ball_surface(1.0, 3);
  std::string text = "solid ball\n";
  for (const auto& face : ball.faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::size_t corner : face)
      text += fmt::format("vertex {} {} {}\n", ball.vertices[corner].x(), ball.vertices[corner].y(),
                          ball.vertices[corner].z());
    text += "endloop\nendfacet\n";
  }
  const SolidReading reading = SolidFiles().read("ball.stl", text + "endsolid ball\n");
  EXPECT_EQ(reading.data->mesh->vertices().size(), ball.vertices.size());
  EXPECT_EQ(reading.data->mesh->edges().size(), 3 * ball.faces.size() / 2);
}

}  // namespace
}  // namespace taut::testing
