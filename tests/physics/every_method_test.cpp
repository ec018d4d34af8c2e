// What must hold for every method in the registry, without naming any.

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

class EveryMethod : public ::testing::TestWithParam<std::string> {
 protected:
  bool can_rigid() const { return find_method(GetParam())->can.rigid; }

  // Gives links a stiffness where the method knows no rigid ones.
  Built build_for_method(Description description) const {
    if (!can_rigid()) {
      for (LinkSpec& link : description.links) link.properties.stiffness = 1e4;
      for (ChainSpec& chain : description.chains) chain.properties.stiffness = 1e4;
    }
    return build_valid(description);
  }
};

// The centre of mass follows the parabola exactly for half-kick methods, v t − g t (t + h)/2 for
// kick-then-drift ones.
TEST_P(EveryMethod, FreeFlightFollowsTheParabola) {
  Description description;
  MassSpec ball;
  ball.name = "ball";
  ball.velocity = {3.0, 4.0, 0.0};
  description.masses = {ball};
  const Built built = build_valid(description);
  const double rate = 240.0, t = 0.5;
  const State end = run(built, settings(GetParam(), rate), t);
  const double exact = 4.0 * t - 0.5 * 9.81 * t * t;
  const double kicked_first = 4.0 * t - 0.5 * 9.81 * t * (t + 1.0 / rate);
  EXPECT_NEAR(end.position.x[0], 3.0 * t, 1e-12);
  EXPECT_TRUE(std::abs(end.position.y[0] - exact) < 1e-12 ||
              std::abs(end.position.y[0] - kicked_first) < 1e-12)
      << end.position.y[0] << " is neither " << exact << " nor " << kicked_first;
  EXPECT_NEAR(end.velocity.y[0], 4.0 - 9.81 * t, 1e-11);
}

// A free mass under drag c falls as v = −(g/c)(1 − e^{−ct}); implicit drag is first order in h.
TEST_P(EveryMethod, DragSlowsAFallToItsTerminalSpeed) {
  Description description;
  description.drag = 2.0;
  MassSpec ball;
  ball.name = "ball";
  description.masses = {ball};
  const Built built = build_valid(description);
  if (!find_method(GetParam())->can.drag) GTEST_SKIP() << "no drag";
  const State end = run(built, settings(GetParam(), 2000.0), 1.0);
  EXPECT_NEAR(end.velocity.y[0], -9.81 / 2.0 * (1.0 - std::exp(-2.0)), 5e-3);
}

TEST_P(EveryMethod, PinsStayWhereTheyAre) {
  Description description = level_chain(10, 0.1);
  description.chains[0].pinned = {"first", "last"};
  description.chains[0].length = 1.2;
  const Built built = build_for_method(description);
  const State end = run(built, settings(GetParam(), 1200.0), 0.5);
  for (const std::size_t pin : {std::size_t{0}, std::size_t{10}}) {
    EXPECT_EQ(end.position.at(pin), built.start.position.at(pin));
    EXPECT_EQ(end.velocity.at(pin), Vec3(0.0, 0.0, 0.0));
  }
}

TEST_P(EveryMethod, DrivenPinsFollowTheirMotion) {
  Description description;
  MassSpec hand, guided, bob;
  hand.name = "hand";
  hand.pinned = true;
  hand.motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 10.0, 0.3};
  guided.name = "guided";
  guided.pinned = true;
  guided.motion.path = {{0.0, {1.0, 0.0, 0.0}}, {0.4, {1.0, 0.5, 0.0}}, {1.0, {2.0, 0.5, 0.0}}};
  bob.name = "bob";
  bob.position = {0.0, -1.0, 0.0};
  description.masses = {hand, guided, bob};
  description.links = {LinkSpec{"hand", "bob", std::nullopt, {}}};
  const Built built = build_for_method(description);
  const State end = run(built, settings(GetParam(), 1000.0), 0.7);
  const double phase = 10.0 * 0.7 + 0.3;
  EXPECT_NEAR(end.position.y[0], 0.1 * std::sin(phase), 1e-12);
  EXPECT_NEAR(end.velocity.y[0], 1.0 * std::cos(phase), 1e-11);
  EXPECT_EQ(end.position.at(1), position_at(built.model.driven_pins[1].motion, 0.7));
  EXPECT_LT(end.position.y[2], end.position.y[0]);
}

// Without gravity, kicks and drifts give momentum only to what pins hold; links pass it from mass to mass.
TEST_P(EveryMethod, LinearMomentumHoldsForUnequalMasses) {
  const Built built = build_for_method(spinning_dumbbell());
  const Vec3 before = linear_momentum(built.model, built.start);
  const State end = run(built, settings(GetParam(), 1200.0), 1.0);
  const double change = (linear_momentum(built.model, end) - before).norm() / before.norm();
  if (GetParam() == "euler")
    EXPECT_EQ(change, 0.0) << "its velocities are never corrected, so this says nothing of its positions";
  else
    EXPECT_LT(change, 1e-11) << "rounding of Δx/h: 3e-13 a step, summed at random over 1200 steps";
}

TEST_P(EveryMethod, TheSameRunGivesTheSameStateBitForBit) {
  const Built built = build_for_method(level_chain(12, 0.05));
  const Settings how = settings(GetParam(), 1200.0);
  EXPECT_EQ(state_hash(run(built, how, 0.25)), state_hash(run(built, how, 0.25)));
}

// A State holds all that a method carries from step to step: stopping and going on changes nothing.
TEST_P(EveryMethod, GoingOnFromASavedStateIsTheSameRun) {
  const Built built = build_for_method(level_chain(12, 0.05));
  const Settings how = settings(GetParam(), 1024.0);  // 1/1024 s is exact, and so are sums of it
  if (complete_settings(how).chooses_steps()) GTEST_SKIP() << "its steps end elsewhere: see GoldenHashes";
  const State whole = run(built, how, 0.25);
  Built half_way{built.model, run(built, how, 0.125), {}};
  EXPECT_EQ(state_hash(run(half_way, how, 0.125)), state_hash(whole));
}

TEST_P(EveryMethod, ANumberThatIsNotFiniteIsReportedAndTheStateKept) {
  Built built = build_for_method(level_chain(4, 0.1));
  built.start.velocity.y[2] = std::numeric_limits<double>::quiet_NaN();
  State state = built.start;
  const RunReport report = simulate(built.model, state, settings(GetParam(), 240.0), 10);
  EXPECT_EQ(report.end, RunEnd::step_failed);
  EXPECT_EQ(state.time, 0.0);
  EXPECT_EQ(state.position, built.start.position);
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryMethod, ::testing::ValuesIn(every_method()), case_name);

}  // namespace
}  // namespace taut::test
