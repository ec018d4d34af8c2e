// A run tells what it did beyond the ordinary; and the run that is timed, judged and drawn is one and the
// same.

#include <fmt/format.h>

#include "fixtures.h"
#include "frames/simulation.h"
#include "measure/work_precision.h"
#include "motion/simulate.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

TEST(RunReport, TellsOfHalvedSteps) {
  Description description = level_chain(40, 1.0 / 40.0);
  description.chains[0].last_mass = 50.0;
  const Built built = build_valid(description);
  taut::Run run(built.model, built.start, settings("newton", 30.0));
  while (run.steps() < 30 && run.step()) {
  }
  const RunReport& report = run.report();
  ASSERT_EQ(run.failure(), "");
  EXPECT_GT(report.halved_steps, 3);
  EXPECT_TRUE(report.worth_telling());
  EXPECT_GE(report.deepest_halving, 1);
  EXPECT_LE(report.first_halved_at, report.last_halved_at);
  const std::string sentence = halving_sentence(built.model, report);
  EXPECT_NE(sentence.find(fmt::format("{} of 30 steps", report.halved_steps)), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("rope."), std::string::npos) << sentence;
}

TEST(RunReport, SaysNothingOfAnOrdinaryRun) {
  const Built built = build_valid(pendulum());
  State state = built.start;
  const RunReport report = simulate(built.model, state, settings("rattle", 600.0), 600);
  EXPECT_EQ(report.halved_steps, 0);
  EXPECT_EQ(halving_sentence(built.model, report), "");
}

TEST(RunReport, ARunWithMoreEnergyThanItCanHaveAfterHalvingsIsRuined) {
  const Built built = build_valid(pendulum());
  RunMeasures measures;
  measures.energy_error = 1.18;
  EXPECT_EQ(ruin_sentence(built.model, measures), "") << "nothing was halved: a method's own error";
  measures.report.halved_steps = 2279;
  measures.report.steps = 3000;
  EXPECT_NE(ruin_sentence(built.model, measures).find("1.18"), std::string::npos);
  measures.energy_error = 0.05;
  EXPECT_EQ(ruin_sentence(built.model, measures), "");
}

// By hash, for every method that takes the scene, drawn between the steps or not.
TEST(OneLoop, TimedJudgedAndDrawnRunsAreTheSame) {
  for (const char* name : {"chain-20", "bridge", "net-catch"}) {
    Scene scene = scene_called(name);
    constexpr double duration = 0.2;  // s
    for (const Method& method : all_methods()) {
      scene.settings = complete_settings(settings(std::string(method.name), 2400.0));
      if (!refusals(scene.model, scene.start, scene.settings).empty()) continue;
      taut::Run judged(scene.model, scene.start, scene.settings, chart_policy);
      judged.at(duration);
      State timed = scene.start;
      simulate(scene.model, timed, scene.settings, judged.steps(), chart_policy);
      Simulation drawn(scene);
      for (int frame = 0; frame < 6; ++frame) drawn.at(duration * frame / 6.3);
      drawn.at(duration);
      EXPECT_EQ(state_hash(timed), state_hash(judged.state())) << name << " " << method.name;
      EXPECT_EQ(state_hash(timed), state_hash(drawn.run().state())) << name << " " << method.name;
    }
  }
}

}  // namespace
}  // namespace taut::test
