#include "fixtures.h"

namespace taut::test {
namespace {

class PlaneMethods : public ::testing::TestWithParam<std::string> {};

Description block_on_slope(double degrees, double friction) {
  const double angle = degrees * 3.14159265358979323846 / 180.0;
  Description description;
  MassSpec block;
  block.name = "block";
  description.masses = {block};
  PlaneSpec plane;
  plane.normal = {std::sin(angle), std::cos(angle), 0.0};
  plane.friction = friction;
  description.planes = {plane};
  return description;
}

// Down a slope a block slides g (sin θ − μ cos θ) t²/2.
TEST_P(PlaneMethods, BlockSlidesByTheLawOfFriction) {
  const Built built = build_valid(block_on_slope(30.0, 0.2));
  const State end = run(built, settings(GetParam(), 2400.0), 1.0);
  const double way = 0.5 * 9.81 * (0.5 - 0.2 * std::sqrt(0.75));
  EXPECT_NEAR(end.position.at(0).norm(), way, 0.01 * way);
  EXPECT_NEAR(end.position.at(0).dot(std::get<HalfSpace>(built.model.colliders.at(0).shape).normal), 0.0,
              1e-9);
}

TEST_P(PlaneMethods, BlockStaysWhereFrictionHoldsIt) {
  const State end = run(build_valid(block_on_slope(30.0, 0.7)), settings(GetParam(), 600.0), 1.0);
  EXPECT_LT(end.position.at(0).norm(), 1e-9);
}

TEST_P(PlaneMethods, NothingFallsThroughTheGround) {
  Description description = level_chain(10, 0.1);
  description.chains[0].pinned = {};
  if (!find_method(GetParam())->can.rigid) description.chains[0].properties.stiffness = 1e5;
  PlaneSpec plane;
  plane.point = {0.0, -0.5, 0.0};
  description.planes = {plane};
  const State end = run(build_valid(description), settings(GetParam(), 600.0), 2.0);
  for (std::size_t i = 0; i < end.position.size(); ++i) EXPECT_NEAR(end.position.y[i], -0.5, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Registry, PlaneMethods,
    ::testing::ValuesIn(methods_that([](const Capabilities& can) { return can.ground; })), case_name);

}  // namespace
}  // namespace taut::test
