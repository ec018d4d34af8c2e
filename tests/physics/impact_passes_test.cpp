// What relaxation makes of jumps of velocity: with the settings it has by default, refining the step alone
// must lead to the motion in which every link answers an impact at once.

#include <fmt/format.h>

#include "fixtures.h"
#include "impact_reference.h"
#include "impact_scenes.h"
#include "model/measures.h"
#include "stopped_pendulum.h"

namespace taut::test {
namespace {

std::vector<std::string> methods_with_impact_passes() {
  std::vector<std::string> names;
  for (const Method& method : all_methods())
    if (find_param(method, "impact_passes") != nullptr) names.emplace_back(method.name);
  return names;
}

class ImpactPasses : public ::testing::TestWithParam<std::string> {
 protected:
  // Errors with the method's defaults at each rate, and the order of their fall. The mean over neighbouring
  // rates: where in the step an impact falls is as good as random.
  template <class Error>
  void expect_convergence(const Built& built, double duration, const std::vector<double>& rates,
                          const Error& error, double at_the_end) const {
    std::vector<double> steps, errors;
    std::string all;
    for (const double rate : rates) {
      double sum = 0.0;
      constexpr int neighbours = 6;
      for (int i = 0; i < neighbours; ++i)
        sum += error(run(built, settings(GetParam(), rate + 4.0 * i), duration));
      steps.push_back(1.0 / rate);
      errors.push_back(sum / neighbours);
      all += fmt::format(" {:.3g} m at {:.0f}/s", errors.back(), rate);
    }
    EXPECT_GT(observed_order(steps, errors), 0.7) << all;
    EXPECT_LT(errors.back(), at_the_end) << all;
  }

  // The same against ImpactReference, over a time with impacts of both of its scenes.
  void expect_the_event_driven_motion(const Built& built) const {
    constexpr double duration = 0.28;  // s
    const State exact = ImpactReference(built.model, built.start, 5e-4).at(duration);
    expect_convergence(
        built, duration, {800.0, 3200.0, 12800.0},
        [&](const State& end) { return position_error(end, exact); }, 2e-3);
  }
};

TEST_P(ImpactPasses, APlasticStopConvergesToTheEventDrivenReference) {
  constexpr double duration = 0.75;  // s
  const Vec3 exact = StoppedPendulum(5e-4).hand_at(duration);
  const Built built = build_valid(stopped_pendulum());
  expect_convergence(
      built, duration, {1600.0, 6400.0, 25600.0},
      [&](const State& end) { return (end.position.at(2) - exact).norm(); }, 1e-3);
}

// Another string crosses the first above it, and the ball comes down beside the middle of both.
Description net_and_ball() {
  Description description = string_and_ball();
  ChainSpec across = description.chains.front();
  across.name = "across";
  across.from = {0.0, 0.1, -0.5};
  across.to = {0.0, 0.1, 0.5};
  description.chains.push_back(across);
  description.masses.front().position = {0.02, 0.2, 0.01};
  return description;
}

TEST(ImpactReference, IsCertified) {
  for (const Description& description : {landing_chain(), string_and_ball()}) {
    const Built built = build_valid(description);
    ImpactReference coarse(built.model, built.start, 1e-3), fine(built.model, built.start, 5e-4);
    const State end = fine.at(0.28);
    EXPECT_GE(fine.events(), 1);
    EXPECT_LT(position_error(coarse.at(0.28), end), 1e-6) << "far below what methods are held to";
  }
}

TEST_P(ImpactPasses, ALandingChainConvergesToTheEventDrivenReference) {
  const Built built = build_valid(landing_chain());
  if (!find_method(GetParam())->can.ground) GTEST_SKIP() << "no ground";
  expect_the_event_driven_motion(built);
}

TEST_P(ImpactPasses, ABallOnAStringConvergesToTheEventDrivenReference) {
  const Built built = build_valid(string_and_ball());
  if (!find_method(GetParam())->can.colliders) GTEST_SKIP() << "no bodies that touch";
  expect_the_event_driven_motion(built);
}

// With friction there is no such reference, but a second opinion: the same step with so many passes that
// every impact is answered to the last digit, at four times the finest rate.
TEST_P(ImpactPasses, ABallInANetConvergesToThatOfManyPasses) {
  const Built built = build_valid(net_and_ball());
  if (!find_method(GetParam())->can.colliders) GTEST_SKIP() << "no bodies that touch";
  constexpr double duration = 0.4;  // s
  const State exact = run(built, settings(GetParam(), 51200.0, 300.0), duration);
  expect_convergence(
      built, duration, {800.0, 3200.0, 12800.0}, [&](const State& end) { return position_error(end, exact); },
      5e-3);
}

TEST_P(ImpactPasses, GivenPassesAreMadeExactly) {
  const Built built = build_valid(stopped_pendulum());
  State state = built.start;
  const StepReport report = simulate(built.model, state, settings(GetParam(), 1000.0, 3.0), 1000).counts;
  EXPECT_EQ(report.rounds, 3000);
}

TEST_P(ImpactPasses, WithoutAStopOrASolidThereIsOnePassAStep) {
  Description description = stopped_pendulum();
  description.angles.clear();
  const Built built = build_valid(description);
  State state = built.start;
  const StepReport report = simulate(built.model, state, settings(GetParam(), 1000.0), 1000).counts;
  EXPECT_EQ(report.rounds, 1000);
}

// What leans against stops at rest has no velocity to lose.
TEST_P(ImpactPasses, LeaningOnStopsCostsNoPasses) {
  Description description = stopped_pendulum();
  description.drag = 10.0;
  MassSpec wall;
  wall.name = "wall";
  wall.position = {-1.0, 0.0, 0.0};
  wall.pinned = true;
  description.masses.push_back(wall);
  AngleSpec angle;
  angle.masses = {"wall", "shoulder", "elbow"};
  angle.min = 160.0;
  description.angles.push_back(angle);
  const Built built = build_valid(description);
  State state = run(built, settings(GetParam(), 1000.0), 1.5);
  EXPECT_LT(fastest_speed(state), 0.02) << "m/s: it does not lean yet";
  const StepReport report = simulate(built.model, state, settings(GetParam(), 1000.0), 300).counts;
  EXPECT_LT(report.rounds, 330);
}

INSTANTIATE_TEST_SUITE_P(Registry, ImpactPasses, ::testing::ValuesIn(methods_with_impact_passes()),
                         case_name);

}  // namespace
}  // namespace taut::test
