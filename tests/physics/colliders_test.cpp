// Solids: friction, rebound, and that nothing is inside them.

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

std::vector<std::string> collider_methods() {
  return methods_that([](const Capabilities& can) { return can.colliders; });
}

class ColliderMethods : public ::testing::TestWithParam<std::string> {};

Description ball_at(const Vec3& position, double radius) {
  Description description;
  MassSpec ball;
  ball.name = "ball";
  ball.position = position;
  ball.radius = radius;
  description.masses = {ball};
  return description;
}

// A box tilted by 30 degrees about z: its upper face falls towards −x.
Description ball_on_tilted_box(double friction) {
  BoxSpec box;
  box.centre = {0.0, 0.0, 0.0};
  box.size = {20.0, 1.0, 4.0};
  box.turn = {0.0, 0.0, 30.0};
  box.friction = friction;
  const double angle = std::numbers::pi / 6.0;
  const Vec3 up(-std::sin(angle), std::cos(angle), 0.0);
  Description description = ball_at(0.6 * up, 0.1);
  description.boxes = {box};
  return description;
}

TEST_P(ColliderMethods, BallSlidesDownATiltedBoxByTheLawOfFriction) {
  const Built built = build_valid(ball_on_tilted_box(0.2));
  const State end = run(built, settings(GetParam(), 2400.0), 1.0);
  const double way = 0.5 * 9.81 * (0.5 - 0.2 * std::sqrt(0.75));
  const Vec3 moved = end.position.at(0) - built.start.position.at(0);
  EXPECT_NEAR(moved.norm(), way, 0.01 * way);
  EXPECT_NEAR(moved.dot(Vec3(-0.5, std::sqrt(0.75), 0.0)), 0.0, 1e-9);
}

TEST_P(ColliderMethods, BallStaysWhereFrictionHoldsIt) {
  const Built built = build_valid(ball_on_tilted_box(0.7));
  const State end = run(built, settings(GetParam(), 600.0), 2.0);
  EXPECT_LT(position_error(end, built.start), 1e-9);
}

// Height after the first rebound: e² of the height it fell from.
TEST_P(ColliderMethods, ReboundFollowsTheRestitution) {
  for (const double restitution : {0.0, 0.5, 0.9}) {
    Description description = ball_at({0.0, 1.1, 0.0}, 0.1);
    PlaneSpec plane;
    plane.restitution = restitution;
    description.planes = {plane};
    const Built built = build_valid(description);
    const double fall = std::sqrt(2.0 / 9.81), rise = restitution * fall;
    // A little past the highest point, where it hardly moves.
    const double time = std::round((fall + rise + 0.005) * 4800.0) / 4800.0;
    const State end = run(built, settings(GetParam(), 4800.0), time);
    EXPECT_NEAR(end.position.y[0] - 0.1, restitution * restitution, 0.01 * restitution * restitution + 1e-9)
        << "restitution " << restitution;
  }
}

TEST_P(ColliderMethods, ABouncingBallComesToRest) {
  Description description = ball_at({0.0, 0.6, 0.0}, 0.1);
  PlaneSpec plane;
  plane.restitution = 0.5;
  description.planes = {plane};
  const Built built = build_valid(description);
  const State late = run(built, settings(GetParam(), 1000.0), 4.0);
  EXPECT_NEAR(late.position.y[0], 0.1, 1e-9);
  if (!find_method(GetParam())->can.half_kicked) {
    EXPECT_LT(fastest_speed(late), 1e-9);
  }
}

struct Landing {
  std::string label;
  std::function<void(Description&)> add;
  Vec3 from, rest;
};

// Balls of 0.1 m that fall on each shape and come to rest on top of it.
TEST_P(ColliderMethods, BallsLieOnEveryShape) {
  const std::vector<Landing> landings{
      {"sphere",
       [](Description& d) {
         d.spheres = {SphereSpec{{0, 0, 0}, 0.5, 0.5, 0.0}};
       },
       {0.0, 1.0, 0.0},
       {0.0, 0.6, 0.0}},
      {"capsule",
       [](Description& d) {
         d.capsules = {CapsuleSpec{{-1, 0, 0}, {1, 0, 0}, 0.3, 0.5, 0.0}};
       },
       {0.4, 1.0, 0.0},
       {0.4, 0.4, 0.0}},
      {"box",
       [](Description& d) {
         d.boxes = {BoxSpec{{0, 0, 0}, {2, 0.4, 1}, {0, 20, 0}, 0.5, 0.0}};
       },
       {0.4, 1.0, 0.1},
       {0.4, 0.3, 0.1}},
      {"planes of a valley",
       [](Description& d) {
         d.planes = {PlaneSpec{{0, 0, 0}, {1, 1, 0}, 0.0, 0.0}, PlaneSpec{{0, 0, 0}, {-1, 1, 0}, 0.0, 0.0}};
       },
       {0.0, 1.0, 0.0},
       {0.0, 0.1 * std::sqrt(2.0), 0.0}},
  };
  for (const Landing& landing : landings) {
    Description description = ball_at(landing.from, 0.1);
    landing.add(description);
    const Built built = build_valid(description);
    const State end = run(built, settings(GetParam(), 600.0, 4.0), 2.0);
    EXPECT_LT((end.position.at(0) - landing.rest).norm(), 1e-6) << landing.label;
    EXPECT_LT(deepest_penetration(built.model, end), 1e-9) << landing.label;
  }
}

// A chain over a box hangs down on both sides of it, and none of it is inside.
TEST_P(ColliderMethods, AChainOverABoxIsNowhereInside) {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.from = {-0.8, 0.6, 0.0};
  chain.to = {0.8, 0.6, 0.0};
  chain.links = 40;
  chain.radius = 0.02;
  description.chains = {chain};
  BoxSpec box;
  box.size = {0.6, 1.0, 0.6};
  box.friction = 0.8;
  description.boxes = {box};
  const Built built = build_valid(description);
  const State end = run(built, settings(GetParam(), 1200.0, 4.0), 2.0);
  EXPECT_LT(deepest_penetration(built.model, end), 1e-6);
  EXPECT_GT(end.position.y[20], 0.5);
  EXPECT_LT(end.position.y[0], 0.1);
}

// Two balls thrown at each other with equal mass share their speeds: nothing is given back between bodies.
TEST_P(ColliderMethods, BodiesThatTouchKeepTheirMomentum) {
  Description description = ball_at({-0.5, 0.0, 0.0}, 0.1);
  description.gravity = Vec3::Zero();
  MassSpec other = description.masses[0];
  other.name = "other";
  other.position = {0.5, 0.0, 0.0};
  other.mass = 3.0;
  description.masses[0].velocity = {2.0, 0.0, 0.0};
  description.masses[0].collides = other.collides = true;
  description.masses.push_back(other);
  const Built built = build_valid(description);
  const State end = run(built, settings(GetParam(), 1000.0, 2.0), 1.0);
  EXPECT_NEAR(end.velocity.x[0], 0.5, 1e-9);
  EXPECT_NEAR(end.velocity.x[1], 0.5, 1e-9);
  EXPECT_GE((end.position.at(0) - end.position.at(1)).norm(), 0.2 - 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Registry, ColliderMethods, ::testing::ValuesIn(collider_methods()), case_name);

// Masses on the ground and what is looked up in a list of near pairs slide by one law of friction: a plane
// that gives nearly nothing back is another way through the program to the same motion.
TEST_P(ColliderMethods, TheGroundRubsAsAnyOtherSolid) {
  Description description = ball_at({0.0, 0.1, 0.0}, 0.1);
  description.masses[0].velocity = {2.0, 0.0, 1.0};
  description.planes = {PlaneSpec{}};
  description.planes[0].friction = 0.3;
  const State on_ground = run(build_valid(description), settings(GetParam(), 600.0), 0.5);
  description.planes[0].restitution = 1e-300;
  const Built listed = build_valid(description);
  EXPECT_FALSE(touches_only_ground(listed.model));
  const State on_solid = run(listed, settings(GetParam(), 600.0), 0.5);
  EXPECT_LT((on_ground.position.at(0) - on_solid.position.at(0)).norm(), 1e-12);
  EXPECT_GT(on_ground.position.at(0).norm(), 0.5) << "it slides";
}

TEST(Colliders, APlaneIsGroundUnlessItGivesSomethingBack) {
  Description description = ball_at({0.0, 1.0, 0.0}, 0.1);
  description.planes = {PlaneSpec{}, PlaneSpec{}};
  const Model ground = build_valid(description).model;
  EXPECT_EQ(ground.colliders.size(), 2U);
  EXPECT_EQ(ground.contacts.size(), 1U);
  EXPECT_TRUE(touches_only_ground(ground));
  description.planes[1].restitution = 0.1;
  EXPECT_FALSE(touches_only_ground(build_valid(description).model));
}

}  // namespace
}  // namespace taut::test
