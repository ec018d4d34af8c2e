#include "measure/reference.h"

#include "fixtures.h"
#include "measure/events.h"
#include "measure/exact.h"
#include "methods/projected_velocities.h"
#include "model/measures.h"

namespace taut::test {
namespace {

TEST(Dop853, PendulumMatchesItsExactMotion) {
  const Built built = build_valid(pendulum());
  const auto states = accurately(built.model, built.start, {0.5, 1.0, 3.0}, 1e-12);
  ASSERT_EQ(states.size(), 3U);
  for (const State& state : states) {
    const double angle = pendulum_angle_below_level(1.0, 9.81, state.time);
    EXPECT_LT((state.position.at(1) - Vec3(std::cos(angle), -std::sin(angle), 0.0)).norm(), 1e-9)
        << state.time;
    EXPECT_NEAR(state.tension[0], 3.0 * 9.81 * std::sin(angle), 1e-7) << state.time;
  }
}

TEST(Reference, ChainOfTwentyLinksIsCertified) {
  const Built built = build_valid(level_chain(20, 0.1));
  const Reference reference = make_reference(built.model, built.start, {0.25, 0.5, 1.0}, 1e-7);
  ASSERT_TRUE(reference.certified()) << reference.refusal;
  EXPECT_EQ(reference.certified_until, 1.0);
  EXPECT_LE(reference.uncertainty, 1e-7);
  const auto tighter = accurately(built.model, built.start, {1.0}, 1e-13);
  EXPECT_LT(position_error(reference.states.back(), tighter.back()), 1e-7);
}

TEST(Reference, DrivenPinsSpringsAndDragAreCertified) {
  Description description = mixed_chain();
  description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.05, 0.0}, 8.0, 0.0};
  const Reference reference =
      make_reference(build_valid(description).model, build_valid(description).start, {0.5}, 1e-6);
  EXPECT_TRUE(reference.certified()) << reference.refusal;
}

// A three-mass pendulum thrown over is chaotic: agreement ends, and the reference says where.
TEST(Reference, ChaosCutsTheCertifiedTime) {
  Description description = level_chain(3, 1.0 / 3.0);
  description.chains[0].to = {0.0, 1.0, 0.0};
  const Built built = build_valid(description);
  State start = built.start;
  start.velocity.x[3] = 6.0;
  start.velocity.x[2] = 4.0;
  start.velocity.x[1] = 2.0;
  const Reference reference = make_reference(built.model, start, {0.5, 2.0, 20.0}, 1e-6);
  ASSERT_TRUE(reference.certified()) << reference.refusal;
  EXPECT_LT(reference.certified_until, 20.0);
  EXPECT_GE(reference.certified_until, 0.5);
}

TEST(Reference, IsRefusedWhereEventsAreNotResolved) {
  Description description = pendulum();
  description.planes = {PlaneSpec{{0.0, -0.5, 0.0}, Vec3::UnitY(), 0.5}};
  const Built built = build_valid(description);
  const Reference reference = make_reference(built.model, built.start, {1.0}, 1e-6);
  EXPECT_FALSE(reference.certified());
  EXPECT_NE(reference.refusal.find("something is touched"), std::string::npos) << reference.refusal;
}

// The bob is at the ground half a metre down after asin(½) of its swing: until then it is certified as if
// there were none, and what lies later is left out.
TEST(Reference, IsCutBeforeTheGroundIsTouched) {
  Description description = pendulum();
  description.planes = {PlaneSpec{{0.0, -0.5, 0.0}, Vec3::UnitY(), 0.5}};
  const Built built = build_valid(description);
  double touch = 0.0;
  while (std::sin(pendulum_angle_below_level(1.0, 9.81, touch)) < 0.5) touch += 1e-4;
  const auto event = first_event(built.model, built.start, 1.0);
  ASSERT_TRUE(event);
  EXPECT_NEAR(event->time, touch, 6e-3);
  const Reference reference = make_reference(built.model, built.start, {0.1, 0.2, 0.3, 0.5}, 1e-6);
  ASSERT_TRUE(reference.certified()) << reference.refusal;
  EXPECT_EQ(reference.certified_until, 0.2);
  EXPECT_GT(time_before(*event), 0.2);
  EXPECT_LT(time_before(*event), 0.3);
}

TEST(Event, IsFoundOnlyWhereSomethingHappens) {
  EXPECT_FALSE(first_event(build_valid(pendulum()).model, build_valid(pendulum()).start, 2.0));
  Description far = pendulum();
  far.planes = {PlaneSpec{{0.0, -1.5, 0.0}, Vec3::UnitY(), 0.5}};
  EXPECT_FALSE(first_event(build_valid(far).model, build_valid(far).start, 2.0));
}

// The link's pull reaches 3 m g at the bottom; it breaks at 2 m g, where 3 sin θ = 2.
TEST(Event, ALinkThatBreaksIsOneWhereItsMomentIsNotFound) {
  Description description = pendulum();
  description.links[0].properties.break_tension = 2.0 * 9.81;
  const Built built = build_valid(description);
  double at = 0.0;
  while (3.0 * std::sin(pendulum_angle_below_level(1.0, 9.81, at)) < 2.0) at += 1e-4;
  EXPECT_FALSE(first_event(built.model, built.start, 1.0)) << "its moment is found";
  const Reference reference = make_reference(built.model, built.start, {0.3, 0.6, 0.9}, 1e-6);
  ASSERT_TRUE(reference.certified()) << reference.refusal;
  EXPECT_EQ(reference.certified_until, 0.9);
  EXPECT_NEAR(reference.states.back().broken_at[0], at, 1e-3);
  // Two links that say the same have no tension to be known.
  description.links.push_back(description.links[0]);
  const Built twice = build_valid(description);
  const auto event = first_event(twice.model, twice.start, 1.0);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->what, "the first link breaks");
}

// What verlet and shake report at rest is rest, not half a kick.
TEST(ProjectedVelocities, OfAHangingMassAreZero) {
  Description description = pendulum();
  description.masses[1].position = {0.0, -1.0, 0.0};
  const Built built = build_valid(description);
  for (const char* method : {"verlet", "shake"}) {
    State end = run(built, settings(method, 600.0), 1.0);
    EXPECT_NEAR(end.velocity.y[1], -9.81 / 1200.0, 1e-9) << method;
    EXPECT_NEAR(projected_velocities(built.model, end).y[1], 0.0, 1e-15) << method;
  }
}

}  // namespace
}  // namespace taut::test
