#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

// A mass of 1 kg on a spring of 100 N/m and 1 m under a slowly growing pull without gravity: the link is
// stretched by f/100.
Description pulled_spring(double pull, LinkProperties properties) {
  Description description = pendulum();
  description.gravity = Vec3::Zero();
  description.drag = 20.0;
  properties.stiffness = 100.0;
  description.links[0].properties = properties;
  description.loads = {LoadSpec{{"bob"}, {pull, 0.0, 0.0}, 0.0, 4.0}};
  return description;
}

class BreakingMethods : public ::testing::TestWithParam<std::string> {};

TEST_P(BreakingMethods, StretchBreaksOnlyAboveTheThreshold) {
  LinkProperties properties;
  properties.break_stretch = 1.2;
  const Settings how = settings(GetParam(), 2400.0, 4.0);
  EXPECT_EQ(broken_links(run(build_valid(pulled_spring(19.9, properties)), how, 6.0)), 0U);
  EXPECT_EQ(broken_links(run(build_valid(pulled_spring(20.4, properties)), how, 6.0)), 1U);
}

TEST_P(BreakingMethods, TensionBreaksOnlyAboveTheThreshold) {
  LinkProperties properties;
  properties.break_tension = 20.0;
  const Settings how = settings(GetParam(), 2400.0, 4.0);
  EXPECT_EQ(broken_links(run(build_valid(pulled_spring(19.9, properties)), how, 6.0)), 0U);
  EXPECT_EQ(broken_links(run(build_valid(pulled_spring(20.4, properties)), how, 6.0)), 1U);
}

INSTANTIATE_TEST_SUITE_P(Registry, BreakingMethods,
                         ::testing::ValuesIn(methods_that([](const Capabilities& can) {
                           return can.stiffness && can.break_stretch && can.break_tension;
                         })),
                         case_name);

// In `euler` a link that is too long is destroyed before its correction; one that is slack is not, whatever
// its threshold.
TEST(EulerBreaking, TestsTheDistanceBeforeEachCorrection) {
  for (const auto& [position, broken] : {std::pair{1.29, 0U}, {1.31, 1U}, {0.2, 0U}}) {
    Description description = pendulum();
    description.gravity = Vec3::Zero();
    description.masses[1].position = {position, 0.0, 0.0};
    description.links[0].properties.break_stretch = 1.3;
    const State end = run(build_valid(description), settings("euler", 60.0), 1.0 / 60.0);
    EXPECT_EQ(broken_links(end), broken) << "at " << position;
    EXPECT_NEAR(end.position.x[1], broken ? position : 1.0, 1e-12);
  }
}

// A link between two pins is in no solve, and still breaks when they are driven apart.
TEST(Breaking, LinkBetweenTwoPinsBreaksByStretch) {
  for (const std::string& method : methods_that([](const Capabilities& can) { return can.break_stretch; })) {
    if (!find_method(method)->can.rigid) continue;
    Description description = pendulum();
    description.masses[1].pinned = true;
    description.masses[1].motion.path = {{0.0, {1.0, 0.0, 0.0}}, {1.0, {2.0, 0.0, 0.0}}};
    description.links[0].properties.break_stretch = 1.5;
    const State end = run(build_valid(description), settings(method, 100.0), 1.0);
    EXPECT_NEAR(end.broken_at[0], 0.51, 0.011) << method;
  }
}

// What broke moves on freely: a pendulum cut while it hangs still falls.
TEST(Breaking, PiecesFallFreely) {
  LinkProperties properties;
  properties.break_tension = 9.0;
  Description description = pendulum();
  description.masses[1].position = {0.0, -1.0, 0.0};
  description.links[0].properties = properties;
  const State end = run(build_valid(description), settings("xpbd", 1000.0), 1.001);
  EXPECT_NEAR(end.broken_at[0], 0.001, 1e-12);
  EXPECT_NEAR(end.position.y[1], -1.0 - 0.5 * 9.81, 0.01);
}

}  // namespace
}  // namespace taut::test
