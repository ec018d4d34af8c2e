// Solids out of meshes: that they are what boxes and balls are, with an error that falls as it should, that
// friction holds on them by its law, that what is open stays open, and that nothing passes through them.

#include <fmt/format.h>

#include "fixtures.h"
#include "model/measures.h"
#include "solid_texts.h"

namespace taut::test {
namespace {

using testing::ball_surface;
using testing::box_surface;
using testing::ring_surface;
using testing::solid_of;

std::vector<std::string> solid_methods() {
  return methods_that([](const Capabilities& can) { return can.colliders; });
}

class MeshSolids : public ::testing::TestWithParam<std::string> {};

MassSpec ball_of(const std::string& name, const Vec3& position, double radius, const Vec3& velocity) {
  MassSpec ball;
  ball.name = name;
  ball.position = position;
  ball.radius = radius;
  ball.velocity = velocity;
  return ball;
}

// A box, and what is thrown at it: from above, from aside, against an edge and a corner.
Description thrown_at(const BoxSpec& box, bool as_mesh) {
  Description description;
  description.masses = {ball_of("above", {0.1, 0.8, 0.05}, 0.1, {0.3, 0.0, 0.1}),
                        ball_of("aside", {-1.2, 0.3, 0.1}, 0.15, {3.0, 1.0, 0.0}),
                        ball_of("point", {-0.2, 0.6, -0.1}, 0.0, {0.4, -1.0, 0.2}),
                        ball_of("edge", {0.3, 1.0, 0.3}, 0.2, {0.2, -1.0, 0.1})};
  if (as_mesh) {
    MeshSolidSpec solid;
    solid.position = box.centre;
    solid.turn = box.turn;
    solid.friction = box.friction;
    solid.restitution = box.restitution;
    solid.moves = box.moves;
    description.mesh_solids = {solid_of(box_surface(box.size), solid)};
  } else {
    description.boxes = {box};
  }
  return description;
}

BoxSpec tilted_box() {
  BoxSpec box;
  box.centre = {0.1, 0.05, 0.0};
  box.size = {0.9, 0.5, 0.7};
  box.turn = {10.0, 20.0, 15.0};
  box.friction = 0.3;
  return box;
}

TEST_P(MeshSolids, ABoxOfFacesMovesThingsAsABox) {
  for (const double restitution : {0.0, 0.6}) {
    BoxSpec box = tilted_box();
    box.restitution = restitution;
    const State of_box = run(build_valid(thrown_at(box, false)), settings(GetParam(), 1200.0), 0.8),
                of_mesh = run(build_valid(thrown_at(box, true)), settings(GetParam(), 1200.0), 0.8);
    EXPECT_LT(position_error(of_box, of_mesh), 1e-9) << restitution;
  }
}

TEST_P(MeshSolids, ABoxOfFacesThatMovesAndTurnsIsABox) {
  BoxSpec box = tilted_box();
  box.moves.motion.path = {{0.0, box.centre}, {0.8, box.centre + Vec3(0.3, 0.4, 0.1)}};
  RotationSpec rotation;
  rotation.axis = {0.3, 1.0, 0.2};
  rotation.rate = 120.0;
  box.moves.rotation = rotation;
  const State of_box = run(build_valid(thrown_at(box, false)), settings(GetParam(), 1200.0), 0.8),
              of_mesh = run(build_valid(thrown_at(box, true)), settings(GetParam(), 1200.0), 0.8);
  // What has no radius and goes in near an edge leaves a box by the nearest face, a mesh by that by which it
  // came.
  for (std::size_t i = 0; i < of_box.position.size(); ++i)
    EXPECT_LT((of_box.position.at(i) - of_mesh.position.at(i)).norm(), i == 2 ? 2e-3 : 1e-9) << i;
}

// Balls that roll off a ball, and stay on it: their middles go along a smooth surface, which comes nearer to
// that around the ball with the square of the edges.
TEST_P(MeshSolids, ABallOfFacesMovesThingsAsABallWithTheSquareOfItsEdges) {
  Description description;
  for (int i = 0; i < 8; ++i) {
    const double around = 0.7 * i, off = 0.01 + 0.01 * i;
    const Vec3 out(std::sin(off) * std::cos(around), std::cos(off), std::sin(off) * std::sin(around));
    const Vec3 along = out.cross(Vec3(std::sin(around), 0.0, -std::cos(around))).normalized();
    description.masses.push_back(ball_of(fmt::format("ball{}", i), 1.5 * out, 0.5, along));
  }
  SphereSpec sphere;
  sphere.friction = 0.0;
  Description with_ball = description;
  with_ball.spheres = {sphere};
  const State expected = run(build_valid(with_ball), settings(GetParam(), 600.0), 0.35);
  std::vector<double> edges, errors;
  for (int level = 2; level <= 5; ++level) {
    Description with_mesh = description;
    MeshSolidSpec solid;
    solid.friction = 0.0;
    with_mesh.mesh_solids = {solid_of(ball_surface(1.0, level), solid)};
    const State state = run(build_valid(with_mesh), settings(GetParam(), 600.0), 0.35);
    double sum = 0.0;
    for (std::size_t i = 0; i < state.position.size(); ++i)
      sum += (state.position.at(i) - expected.position.at(i)).squaredNorm();
    edges.push_back(std::exp2(-level));
    errors.push_back(std::sqrt(sum / static_cast<double>(state.position.size())));
  }
  EXPECT_NEAR(observed_order(edges, errors), 2.0, 0.35) << ::testing::PrintToString(errors);
  EXPECT_LT(errors.back(), 1e-3);
}

// What slides without a radius loses at each edge what of its speed goes into the next face: (v δ)²/2 for a
// turn by δ, and 1/δ of them.
TEST_P(MeshSolids, AMassWithoutRadiusLosesSpeedAtEdgesInProportionToThem) {
  Description description;
  description.gravity = Vec3::Zero();
  description.masses = {ball_of("point", {0.0, -0.95, 0.0}, 0.0, {1.0, 0.0, 0.1})};
  std::vector<double> edges, losses;
  for (int level = 2; level <= 5; ++level) {
    Description with_mesh = description;
    MeshSolidSpec solid;
    solid.friction = 0.0;
    testing::Surfaces bowl = ball_surface(1.2, 2);  // around a hollow, in which it slides
    bowl.add(ball_surface(1.0, level), Vec3::Zero());
    with_mesh.mesh_solids = {solid_of(bowl, solid)};
    const Built built = build_valid(with_mesh);
    // It has come to the surface after a third of a second.
    const State early = run(built, settings(GetParam(), 2400.0), 1.0),
                late = run(built, settings(GetParam(), 2400.0), 3.0);
    edges.push_back(std::exp2(-level));
    // dv/dt = −k v², so that k is:
    losses.push_back(1.0 / late.velocity.at(0).norm() - 1.0 / early.velocity.at(0).norm());
  }
  EXPECT_NEAR(observed_order(edges, losses), 1.0, 0.3) << ::testing::PrintToString(losses);
}

// g sin θ − µ g cos θ, on a plane of many faces.
TEST_P(MeshSolids, AMassSlidesDownASlopeByTheLawOfFriction) {
  const double slope = std::numbers::pi / 6.0;
  testing::Surfaces board = box_surface({8.0, 1.0, 4.0});
  for (const double friction : {0.0, 0.2, 0.7}) {
    MeshSolidSpec solid;
    solid.turn = {0.0, 0.0, -30.0};
    solid.friction = friction;
    const Vec3 up(std::sin(slope), std::cos(slope), 0.0), down(std::cos(slope), -std::sin(slope), 0.0);
    for (const double radius : {0.0, 0.1}) {
      Description description;
      description.masses = {ball_of("ball", (0.5 + radius) * up - 2.0 * down, radius, Vec3::Zero())};
      description.mesh_solids = {solid_of(board, solid)};
      const Built built = build_valid(description);
      const State end = run(built, settings(GetParam(), 2400.0), 1.0);
      const double way = std::max(0.0, 0.5 * 9.81 * (std::sin(slope) - friction * std::cos(slope)));
      const Vec3 moved = end.position.at(0) - built.start.position.at(0);
      EXPECT_NEAR(moved.dot(down), way, 0.01 * way + 1e-9) << friction;
      EXPECT_NEAR(moved.dot(up), 0.0, 1e-9);
    }
  }
}

// A ring about the vertical: what is narrower than its hole falls through as if there were no ring, what is
// wider comes to lie in it.
TEST_P(MeshSolids, ABallFallsThroughTheHoleOfARingThatIsWideEnough) {
  const testing::Surfaces ring = ring_surface(0.5, 0.2, 64, 32);  // a hole of 0.3 m in radius
  for (const double radius : {0.28, 0.4}) {
    Description description;
    description.drag = radius > 0.3 ? 3.0 : 0.0;
    description.masses = {ball_of("ball", {0.0, 0.8, 0.0}, radius, Vec3::Zero())};
    description.mesh_solids = {solid_of(ring)};
    const Built built = build_valid(description);
    Description free = description;
    free.mesh_solids.clear();
    const double duration = radius > 0.3 ? 6.0 : 0.6;
    const State end = run(built, settings(GetParam(), 1200.0), duration);
    if (radius < 0.3) {
      EXPECT_LT(position_error(end, run(build_valid(free), settings(GetParam(), 1200.0), duration)), 1e-12);
    } else {
      // Its middle is 0.2 + 0.4 from the ring's middle line.
      EXPECT_NEAR(end.position.y[0], std::sqrt(0.6 * 0.6 - 0.5 * 0.5), 3e-3);
      if (!find_method(GetParam())->can.half_kicked) {
        EXPECT_LT(fastest_speed(end), 1e-3);
      }
    }
  }
}

// One millimetre thick, and hit at 40 m/s: seven centimetres a step. The wall that comes is as fast.
TEST_P(MeshSolids, NothingGoesThroughAThinWall) {
  for (const bool wall_moves : {false, true})
    for (const double radius : {0.0, 0.01, 0.05}) {
      Description description;
      description.gravity = Vec3::Zero();
      const Vec3 way(0.0, -40.0, 0.0);
      description.masses = {ball_of("ball", {0.1, 0.5, 0.1}, radius, wall_moves ? Vec3::Zero() : way)};
      MeshSolidSpec wall;
      if (wall_moves) wall.moves.motion.path = {{0.0, Vec3::Zero()}, {0.1, Vec3(0.0, 4.0, 0.0)}};
      description.mesh_solids = {solid_of(box_surface({1.0, 0.001, 1.0}), wall)};
      const Built built = build_valid(description);
      taut::Run moving(built.model, built.start, settings(GetParam(), 600.0));
      for (int step = 0; step < 60; ++step) {
        ASSERT_TRUE(moving.step());
        const auto shape = std::get<MeshSolid>(shape_at(built.model.colliders[0], moving.state().time));
        ASSERT_GT(moving.state().position.y[0] - shape.centre.y(), 0.0005 + radius - 1e-9)
            << radius << " m, step " << step << (wall_moves ? ", the wall moves" : "");
      }
    }
}

TEST_P(MeshSolids, WhatStartsInsideIsRefused) {
  Description description;
  description.masses = {ball_of("ball", {0.5, 0.1, 0.0}, 0.05, Vec3::Zero())};
  description.mesh_solids = {solid_of(ring_surface(0.5, 0.2, 32, 16))};
  const Built built = build(description);
  ASSERT_EQ(built.problems.size(), 1U);
  EXPECT_EQ(built.problems[0].section, "solid");
  EXPECT_EQ(built.problems[0].message.substr(0, 22), "at the start \"ball\" is");
  // In the hole it is not.
  description.masses[0].position = Vec3::Zero();
  EXPECT_TRUE(build(description).problems.empty());
}

INSTANTIATE_TEST_SUITE_P(All, MeshSolids, ::testing::ValuesIn(solid_methods()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace taut::test
