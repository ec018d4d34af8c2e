// Masses that are balls, single ones and those of chains, on the faces of sheets: however coarse these are,
// and however small and fast the balls, none falls through.

#include <fmt/format.h>

#include "face_scenes.h"

namespace taut::test {
namespace {

class FacesAndBalls : public ::testing::TestWithParam<std::string> {};

// Of 8 by 8 cells of 0.25 m, held all around.
SheetSpec trampoline(bool faces) {
  SheetSpec sheet = sheet_around("trampoline", Vec3::Zero(), Eigen::Matrix3d::Identity(), 2.0, 8, 0.02);
  sheet.pinned = {"top", "bottom", "left", "right"};
  sheet.properties.stiffness = 5000.0;
  sheet.properties.damping = 2.0;
  if (!faces) {
    sheet.faces.reset();
    sheet.radius = 0.01;
  }
  return sheet;
}

MassSpec ball_above(double height, double radius, double mass) {
  MassSpec ball;
  ball.name = "ball";
  ball.position = {0.11, height + radius, 0.07};  // above the inside of a triangle
  ball.mass = mass;
  ball.radius = radius;
  ball.collides = true;
  return ball;
}

// Whether all that is not of the sheet is above it or beside it: straight up from there it is met as often
// from below as from above, folded as it may be.
bool all_above(const Built& built, const State& state) {
  const Sheet& sheet = built.model.sheets[0];
  for (Index i = 0; i < built.model.masses.size(); ++i) {
    if (i >= sheet.first_mass && i < sheet.first_mass + sheet.mass_count) continue;
    const Vec3 from = state.position.at(i), to = from + Vec3(0.0, 1e3, 0.0);
    const auto met = std::ranges::count_if(built.model.triangles, [&](const Triangle& triangle) {
      const PlacedTriangle there = placed(triangle, state);
      return boxes_meet({from, to}, there) && goes_through(from, to, there);
    });
    if (met % 2 != 0) return false;
  }
  return true;
}

// Beyond the rim, around which it may come below.
bool is_off(const Vec3& ball) {
  return std::max(std::abs(ball.x()), std::abs(ball.z())) > 0.98;
}

TEST_P(FacesAndBalls, AHeavyBallRestsOnACoarseTrampoline) {
  for (const double radius : {0.005, 0.05, 0.2}) {
    Description description;
    description.sheets = {trampoline(true)};
    description.masses = {ball_above(0.1, radius, 3.0)};
    description.drag = 2.0;
    const Built built = built_for(GetParam(), description);
    const State state = run(built, settings(GetParam(), 600.0, 4.0), 6.0);
    const Index ball = static_cast<Index>(built.model.masses.size() - 1);
    EXPECT_TRUE(all_above(built, state)) << radius;
    EXPECT_LT(state.velocity.at(ball).norm(), 0.02) << radius;
    EXPECT_LT(deepest_penetration(built.model, state), 0.2 * (radius + 0.01)) << radius;
    EXPECT_LT(state.position.at(ball).y(), radius + 0.01) << radius;  // it has come down on it
  }
}

// What used to be: corners hold balls, faces don't.
TEST_P(FacesAndBalls, WithoutFacesItFallsThrough) {
  Description description;
  description.sheets = {trampoline(false)};
  description.masses = {ball_above(0.1, 0.05, 3.0)};
  const Built built = built_for(GetParam(), description);
  EXPECT_FALSE(all_above(built, run(built, settings(GetParam(), 600.0, 4.0), 1.0)));
}

TEST_P(FacesAndBalls, NoneShootsThroughAtAnySpeed) {
  for (const double speed : {1.0, 10.0, 100.0})
    for (const double rate : {60.0, 600.0})
      for (unsigned seed = 0; seed < 6; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> aside(-0.8, 0.8);
        Description description;
        description.sheets = {trampoline(true)};
        description.masses = {ball_above(0.3, 0.02, 0.2)};
        const double x = aside(random);
        description.masses[0].position = {x, 0.3, aside(random)};
        description.masses[0].velocity = {0.2 * speed, -speed, 0.1 * speed};
        const Built built = built_for(GetParam(), description);
        taut::Run moving(built.model, built.start, settings(GetParam(), rate, 2));
        while (moving.state().time < 2.0 / speed + 3.0 / rate) {
          const State before = moving.state();
          ASSERT_TRUE(moving.step()) << moving.failure();
          if (is_off(moving.state().position.at(built.model.masses.size() - 1))) break;
          const int looks = rate < 100.0 ? 4 : 1;
          for (int look = 1; look <= looks; ++look) {
            State between = moving.state();
            for (Index i = 0; i < built.model.masses.size(); ++i)
              between.position.set(
                  i, before.position.at(i) + static_cast<double>(look) / looks *
                                                 (moving.state().position.at(i) - before.position.at(i)));
            ASSERT_TRUE(all_above(built, between))
                << fmt::format("{} m/s at {}/s, seed {}, {} s", speed, rate, seed, between.time);
          }
        }
      }
}

TEST_P(FacesAndBalls, AChainDoesNotSlipThrough) {
  Description description;
  description.sheets = {trampoline(true)};
  ChainSpec chain;
  chain.name = "chain";
  chain.from = {-0.4, 0.1, -0.3};
  chain.to = {0.4, 0.3, 0.35};
  chain.links = 24;
  chain.mass = 2.0;
  chain.radius = 0.01;
  chain.collides = true;
  description.chains = {chain};
  description.drag = 1.0;
  const Built built = built_for(GetParam(), description);
  taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 4.0));
  while (moving.steps() < 1200) {
    ASSERT_TRUE(moving.step()) << moving.failure();
    ASSERT_TRUE(all_above(built, moving.state())) << moving.state().time;
  }
}

TEST_P(FacesAndBalls, MomentumIsKept) {
  Description description;
  description.gravity = Vec3::Zero();
  SheetSpec sheet = trampoline(true);
  sheet.pinned.clear();
  description.sheets = {sheet};
  description.masses = {ball_above(0.1, 0.05, 0.5)};
  description.masses[0].velocity = {1.0, -3.0, 0.0};
  const Built built = built_for(GetParam(), description);
  const State end = run(built, settings(GetParam(), 600.0, 2.0), 0.4);
  const Vec3 before = linear_momentum(built.model, built.start), after = linear_momentum(built.model, end);
  EXPECT_LT((after - before).norm(), 1e-10 * before.norm());
  EXPECT_GT(end.velocity.at(built.model.masses.size() - 1).y(), -2.9);  // it has hit
}

// A ball on a link from a corner, nearer than the two are thick.
TEST_P(FacesAndBalls, ALinkJoinsABallToACornerHoweverNear) {
  Description description;
  description.gravity = Vec3::Zero();
  description.sheets = {trampoline(true)};
  MassSpec ball = ball_above(0.0, 0.05, 1.0);
  ball.position = {0.0, 0.03, 0.0};
  description.masses = {ball};
  LinkSpec link;
  link.a = "ball";
  link.b = "trampoline.4.4";
  description.links = {link};
  const Built built = built_for(GetParam(), description);
  EXPECT_LT(position_error(run(built, settings(GetParam(), 600.0, 2.0), 0.2), built.start), 1e-6);
}

TEST(FacesAndBallsStart, ABallThatStartsInAFaceIsRefused) {
  Description description;
  description.sheets = {trampoline(true)};
  description.masses = {ball_above(-0.02, 0.05, 1.0)};
  const Built built = build(description);
  ASSERT_EQ(built.problems.size(), 1U);
  EXPECT_EQ(built.problems[0].key, "faces");
  EXPECT_NE(
      built.problems[0].message.find("at least their thickness apart, 0.06 m: \"ball\" and the face of"),
      std::string::npos)
      << built.problems[0].message;
}

INSTANTIATE_TEST_SUITE_P(All, FacesAndBalls, ::testing::ValuesIn(face_methods()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace taut::test
