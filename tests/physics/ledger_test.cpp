#include "fixtures.h"
#include "model/measures.h"
#include "motion/run.h"
#include "motion/work_ledger.h"

namespace taut::test {
namespace {

// Total energy gained over a run, and what the ledger says it should be.
std::pair<double, double> gain_and_ledger(const Built& built, const Settings& given, int steps) {
  taut::Run run(built.model, built.start, given);
  while (run.steps() < steps && run.step()) {
  }
  EXPECT_EQ(run.failure(), "");
  return {energy(built.model, run.state()).total() - energy(built.model, built.start).total(),
          run.work().expected_gain()};
}

TEST(WorkLedger, DrivenPinPaysForTheEnergyItPutsIn) {
  Description description = level_chain(5, 0.2);
  description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 12.0, 0.0};
  const auto [gain, expected] = gain_and_ledger(build_valid(description), settings("rattle", 8000.0), 8000);
  EXPECT_GT(std::abs(gain), 1.0);
  EXPECT_NEAR(gain, expected, 2e-3 * std::abs(gain));
}

TEST(WorkLedger, LoadPaysForTheEnergyItPutsIn) {
  Description description = pendulum();
  description.loads = {LoadSpec{{"bob"}, {30.0, 5.0, 0.0}, 0.0, 1.0}};
  const auto [gain, expected] = gain_and_ledger(build_valid(description), settings("rattle", 4000.0), 4000);
  EXPECT_GT(gain, 1.0);
  EXPECT_NEAR(gain, expected, 1e-4 * gain);
}

TEST(WorkLedger, BrokenSpringTakesItsEnergyAlong) {
  Description description = pendulum();
  description.gravity = Vec3::Zero();
  description.masses[1].velocity = {3.0, 0.0, 0.0};
  description.links[0].properties.stiffness = 100.0;
  description.links[0].properties.break_tension = 20.0;  // stretched by 0.2 m: 2 J
  const auto [gain, expected] = gain_and_ledger(build_valid(description), settings("rattle", 20000.0), 20000);
  EXPECT_NEAR(expected, -2.0, 0.01);
  EXPECT_NEAR(gain, expected, 1e-4);
}

// Of long steps, too.
TEST(WorkLedger, LongStepsOfHighOrderAreAddedUpAsWell) {
  Description description = level_chain(5, 0.2);
  description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 12.0, 0.0};
  description.loads = {LoadSpec{{"rope.5"}, {8.0, 3.0, 0.0}, 0.1, 0.6}};
  const Built built = build_valid(description);
  taut::Run run(built.model, built.start, settings("dop853", 240.0));
  ASSERT_TRUE(run.at(1.0)) << run.failure();
  const double gain = energy(built.model, run.state()).total() - energy(built.model, built.start).total();
  EXPECT_LT(run.steps(), 300);
  EXPECT_GT(std::abs(run.work().pins), 1.0);
  EXPECT_GT(std::abs(run.work().loads), 1.0);
  EXPECT_NEAR(gain, run.work().expected_gain(), 1e-6 * run.work().throughput);
}

}  // namespace
}  // namespace taut::test
