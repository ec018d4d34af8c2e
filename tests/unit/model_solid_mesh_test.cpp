// Distances from solids out of meshes, against ways of having them that share nothing with the tree.

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "model/colliders.h"
#include "model/face_depth.h"
#include "model/face_pairs.h"
#include "solid_texts.h"

namespace taut {
namespace {

using testing::ball_surface;
using testing::box_surface;
using testing::ring_surface;
using testing::shape_of;
using testing::Surfaces;

// Places within a cube, the same each time.
std::vector<Vec3> strewn_places(int count, double half_width, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> along(-half_width, half_width);
  std::vector<Vec3> places;
  for (int i = 0; i < count; ++i) places.emplace_back(along(random), along(random), along(random));
  return places;
}

// The least distance from any triangle, and by the sum of the solid angles whether it is inside (van Oosterom
// and Strackee, The Solid Angle of a Plane Triangle, 1983).
double distance_by_all(const SolidMesh& mesh, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity(), angles = 0.0;
  for (Index i = 0; i < mesh.triangles().size(); ++i) {
    const auto [a, b, c] = mesh.corners_of(i);
    least = std::min(least, nearest_gap(false, {point, a, b, c}).distance);
    const Vec3 u = a - point, v = b - point, w = c - point;
    angles += 2.0 * std::atan2(u.dot(v.cross(w)), u.norm() * v.norm() * w.norm() + u.dot(v) * w.norm() +
                                                      v.dot(w) * u.norm() + w.dot(u) * v.norm());
  }
  return std::abs(angles) > 2.0 * std::numbers::pi ? -least : least;
}

// A ring beside a box with a hollow in it.
Surfaces ring_and_hollow_box() {
  Surfaces all = ring_surface(0.5, 0.2, 24, 12);
  all.add(box_surface({0.6, 0.5, 0.7}), {0.1, 0.9, 0.0});
  all.add(box_surface({0.3, 0.2, 0.4}), {0.12, 0.88, 0.03});
  return all;
}

TEST(SolidMesh, DistancesAreThoseOfAllTriangles) {
  const MeshSolid solid = shape_of(ring_and_hollow_box());
  int inside = 0;
  for (const Vec3& place : strewn_places(3000, 1.2)) {
    const double expected = distance_by_all(*solid.mesh, solid.back(place));
    const Surface surface = nearest_surface(solid, place);
    ASSERT_NEAR(surface.distance, expected, 1e-13) << place.transpose();
    ASSERT_NEAR(surface.normal.norm(), 1.0, 1e-12);
    // Along the normal it is as far as it says to where it is none.
    ASSERT_NEAR(nearest_surface(solid, place - surface.distance * surface.normal).distance, 0.0, 1e-12);
    inside += expected < 0.0 ? 1 : 0;
  }
  EXPECT_GT(inside, 50);
}

// Of a box that is turned by any axis the mesh has what the box has.
TEST(SolidMesh, ABoxOfFacesIsABox) {
  const Vec3 size(0.7, 0.4, 1.1);
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(0.8, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  MeshSolid solid = shape_of(box_surface(size));
  solid.centre = {0.2, -0.1, 0.3};
  solid.axes = axes;
  const Box box{solid.centre, 0.5 * size, axes};
  for (const Vec3& place : strewn_places(3000, 1.0)) {
    const Surface of_mesh = nearest_surface(solid, place), of_box = nearest_surface(box, place);
    ASSERT_NEAR(of_mesh.distance, of_box.distance, 1e-14);
    ASSERT_LT((of_mesh.normal - of_box.normal).norm(), 1e-9) << place.transpose();
  }
}

TEST(SolidMesh, WithinIsTheNearestWhereThatIsNear) {
  const MeshSolid solid = shape_of(ring_and_hollow_box());
  for (const Vec3& place : strewn_places(3000, 1.2)) {
    const Surface nearest = solid.mesh->nearest(place);
    for (const double reach : {0.0, 1e-4, 0.02, 0.3, 5.0}) {
      const auto near = solid.mesh->within(place, reach);
      ASSERT_EQ(near.has_value(), nearest.distance < reach) << place.transpose() << " within " << reach;
      if (near) {
        ASSERT_EQ(near->distance, nearest.distance);
        ASSERT_EQ(near->normal, nearest.normal);
      }
    }
  }
}

// Corners of the mesh are on the ball, so that faces are inside it by h²/8 of its curvature.
TEST(SolidMesh, ABallOfFacesComesNearerToABallWithTheSquareOfItsEdges) {
  std::vector<double> errors;
  for (int level = 1; level <= 4; ++level) {
    const MeshSolid solid = shape_of(ball_surface(0.8, level));
    double largest = 0.0;
    for (const Vec3& place : strewn_places(2000, 1.0))
      if (place.norm() > 0.4)
        largest = std::max(largest, std::abs(nearest_surface(solid, place).distance -
                                             nearest_surface(Sphere{Vec3::Zero(), 0.8}, place).distance));
    errors.push_back(largest);
  }
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 2.0, 0.2);
}

// A way through a wall one millimetre thick.
TEST(SolidMesh, WhatWentThroughIsSentBackTheWayItCame) {
  const MeshSolid wall = shape_of(box_surface({1.0, 0.001, 1.0}));
  const Vec3 above(0.1, 0.2, 0.1);
  for (const double y : {-0.0002, -0.3}) {
    const Vec3 place(0.1, y, 0.1);
    const auto surface = surface_on_way(wall, above, place, 0.01);
    ASSERT_TRUE(surface);
    EXPECT_NEAR(surface->distance, y - 0.0005, 1e-12);
    EXPECT_LT((surface->normal - Vec3::UnitY()).norm(), 1e-12);
  }
  EXPECT_NEAR(surface_on_way(wall, above, {0.1, 0.0002, 0.1}, 0.01)->distance, -0.0003, 1e-12);
  // What lies on it, a little too deep, when the wall comes.
  const auto from_within = surface_on_way(wall, {0.1, 0.0005 - 1e-15, 0.1}, {0.1, -0.07, 0.1}, 0.01);
  ASSERT_TRUE(from_within);
  EXPECT_NEAR(from_within->distance, -0.0705, 1e-12);
  EXPECT_NEAR(surface_on_way(wall, {0.1, 0.0005 - 1e-15, 0.1}, {0.1, -0.0002, 0.1}, 0.01)->distance, -0.0007,
              1e-12);
  EXPECT_FALSE(surface_on_way(wall, above, {3.0, -0.3, 0.1}, 0.01)) << "past its edge";
}

// Edges between triangles let nothing slip.
TEST(SolidMesh, NoWayGoesBetweenTriangles) {
  const MeshSolid ball = shape_of(ball_surface(1.0, 2));
  for (const Vec3& vertex : ball.mesh->vertices())
    for (const SolidMesh::Edge& edge : ball.mesh->edges()) {
      const Vec3 on_edge = 0.5 * (ball.mesh->vertices()[edge.ends[0]] + ball.mesh->vertices()[edge.ends[1]]);
      ASSERT_TRUE(ball.mesh->crossing(2.0 * on_edge, Vec3::Zero()).enters);
      ASSERT_TRUE(ball.mesh->crossing(2.0 * vertex, Vec3::Zero()).enters);
    }
}

TEST(SolidMesh, EdgesThatStandOutAreRidges) {
  const MeshSolid box = shape_of(box_surface({1.0, 2.0, 3.0}));
  EXPECT_EQ(std::ranges::count_if(box.mesh->edges(), &SolidMesh::Edge::ridge), 12) << "and no diagonal";
  // Across the hole of a ring the edges from one side of its tube to the other are hollows.
  const MeshSolid ring = shape_of(ring_surface(1.0, 0.3, 20, 8));
  int hollows = 0;
  for (const SolidMesh::Edge& edge : ring.mesh->edges()) {
    const Vec3 &a = ring.mesh->vertices()[edge.ends[0]], &b = ring.mesh->vertices()[edge.ends[1]];
    const bool across = std::abs(std::atan2(a.z(), a.x()) - std::atan2(b.z(), b.x())) < 1e-9;
    if (!across || (a + b).norm() > 2.0 * 0.9) continue;
    EXPECT_FALSE(edge.ridge);
    ++hollows;
  }
  EXPECT_GT(hollows, 20);
}

// By places all over the triangle, which can only be farther away.
TEST(SolidMesh, LeastDistancesOfTriangles) {
  const MeshSolid solid = shape_of(ring_surface(0.5, 0.2, 24, 12));
  const std::vector<Vec3> corners = strewn_places(600, 0.9, 8), shifts = strewn_places(600, 0.6, 9);
  int crossing = 0, outside = 0, with_corners_outside = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const std::array<Vec3, 3> triangle{corners[i], corners[i] + shifts[i], corners[i] + shifts[i + 1]};
    double sampled = std::numeric_limits<double>::infinity();
    for (int u = 0; u <= 60; ++u)
      for (int v = 0; u + v <= 60; ++v)
        sampled =
            std::min(sampled, nearest_surface(solid, triangle[0] + (triangle[1] - triangle[0]) * (u / 60.0) +
                                                         (triangle[2] - triangle[0]) * (v / 60.0))
                                  .distance);
    const double least = least_distance(Shape(solid), triangle);
    if (sampled > 0.01) {
      EXPECT_LE(least, sampled + 1e-12);
      EXPECT_GT(least, sampled - 0.01);
      ++outside;
    } else if (sampled < -0.01) {
      EXPECT_LT(least, 0.0);
      with_corners_outside += std::ranges::all_of(
          triangle, [&](const Vec3& corner) { return nearest_surface(solid, corner).distance > 0.0; });
      EXPECT_NEAR(least, sampled, 0.02);
      ++crossing;
    }
  }
  EXPECT_GT(outside, 20);
  EXPECT_GT(crossing, 20);
  EXPECT_GT(with_corners_outside, 5);
}

}  // namespace
}  // namespace taut
