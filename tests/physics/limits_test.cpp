// Limits on angles in motion.

#include "fixtures.h"
#include "model/measures.h"
#include "stopped_pendulum.h"

namespace taut::test {
namespace {

constexpr double pi = std::numbers::pi;

class LimitMethods : public ::testing::TestWithParam<std::string> {};

constexpr double pendulum_time = 0.75;  // s

TEST(StoppedPendulumReference, IsCertified) {
  StoppedPendulum coarse(1e-3), fine(5e-4);
  const Vec3 place = fine.hand_at(pendulum_time);
  EXPECT_GE(fine.events(), 1);
  EXPECT_LT((coarse.hand_at(pendulum_time) - place).norm(), 1e-9);
}

// An impact falls anywhere within a step, so no method is of more than first order across it.
TEST_P(LimitMethods, DoublePendulumWithAStopConvergesToTheReferenceWithFirstOrder) {
  const Vec3 exact = StoppedPendulum(5e-4).hand_at(pendulum_time);
  const Built built = build_valid(stopped_pendulum());
  std::vector<double> steps, errors;
  // The mean over neighbouring step sizes: where in the step the impact falls is as good as random.
  for (const double rate : {400.0, 1600.0, 6400.0}) {
    double sum = 0.0;
    constexpr int neighbours = 8;
    for (int i = 0; i < neighbours; ++i) {
      const double near = rate + 4.0 * i;
      sum += (run(built, settings(GetParam(), near, 60.0), pendulum_time).position.at(2) - exact).norm();
    }
    steps.push_back(1.0 / rate);
    errors.push_back(sum / neighbours);
  }
  EXPECT_GT(observed_order(steps, errors), 0.8);
  EXPECT_LT(observed_order(steps, errors), 1.4);
  EXPECT_LT(errors.back(), 5e-3);
}

TEST_P(LimitMethods, NoStopIsPassedByMoreThanADegree) {
  const Built built = build_valid(stopped_pendulum());
  State state = built.start;
  for (int frame = 0; frame < 100; ++frame) {
    Built next{built.model, state, {}};
    state = run(next, settings(GetParam(), 1000.0, 20.0), 0.02);
    EXPECT_LT(largest_limit_excess(built.model, state), pi / 180.0) << "at " << state.time << " s";
  }
}

// A body with a stop at its elbow, tumbling freely.
TEST_P(LimitMethods, AStopLeavesMomentumAlone) {
  Description description = stopped_pendulum();
  description.gravity = Vec3::Zero();
  description.masses[0].pinned = false;
  description.masses[0].velocity = {0.3, 1.0, 0.2};
  description.masses[2].velocity = {0.0, 2.0, 0.5};
  const Built built = build_valid(description);
  const Vec3 before = linear_momentum(built.model, built.start);
  // Every correction rounds positions at 4e-16 m, and so velocities at that over h; there are ten thousand,
  // at random.
  const State rough = run(built, settings(GetParam(), 1000.0, 3.0), 1.0);
  EXPECT_LT((linear_momentum(built.model, rough) - before).norm(), 1e-10 * before.norm());
  const State fine = run(built, settings(GetParam(), 8000.0, 20.0), 1.0);
  const Vec3 spin = angular_momentum(built.model, built.start);
  EXPECT_LT((angular_momentum(built.model, fine) - spin).norm(), 0.01 * spin.norm());
}

TEST_P(LimitMethods, AStopThatIsReachedAtRestInjectsNothing) {
  Description description = stopped_pendulum();
  description.gravity = Vec3::Zero();
  description.angles[0].min = 180.0;
  const Built built = build_valid(description);
  const State end = run(built, settings(GetParam(), 600.0, 5.0), 1.0);
  EXPECT_LT(position_error(end, built.start), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Registry, LimitMethods, ::testing::ValuesIn(limit_methods()), case_name);

}  // namespace
}  // namespace taut::test
