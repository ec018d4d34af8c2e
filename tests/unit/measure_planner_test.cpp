#include <gtest/gtest.h>

#include "measure/cost.h"
#include "measure/work_precision.h"
#include "run/scene_plan.h"
#include "run/scene_truth.h"
#include "temporary_folder.h"

namespace taut {
namespace {

TEST(Accuracy, IsReadWithKindAndUnit) {
  const auto plain = parse_accuracy("1%");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->kind, ErrorKind::trajectory);
  EXPECT_DOUBLE_EQ(plain->error, 0.01);
  EXPECT_FALSE(plain->metres);
  const auto length = parse_accuracy("trajectory=1mm");
  ASSERT_TRUE(length);
  EXPECT_DOUBLE_EQ(length->error, 1e-3);
  EXPECT_TRUE(length->metres);
  EXPECT_EQ(parse_accuracy("strain=1e-3")->kind, ErrorKind::strain);
  EXPECT_DOUBLE_EQ(parse_accuracy("sag=0.5%")->error, 0.005);
  for (const char* bad : {"", "%", "fast", "1%%", "-1%", "0", "nan", "inf", "strain=1mm", "speed=1%", "sag="})
    EXPECT_FALSE(parse_accuracy(bad)) << bad;
}

Scene scene_named(const std::string& name) {
  return load_scene(std::string(TAUT_SCENE_FOLDER) + "/" + name + ".toml");
}

// The plan's run, judged against the certified motion.
class PlanTest : public ::testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(PlanTest, MeetsItsTargetAndIsTheSameTwice) {
  const auto [name, wanted] = GetParam();
  const testing::TemporaryFolder folder;
  const Scene scene = scene_named(name);
  const AccuracyTarget target{ErrorKind::trajectory, wanted, false};
  const Plan plan = plan_scene(scene, target, {}, folder.path());
  EXPECT_TRUE(plan.reached) << plan.why;
  const Truth truth = scene_truth(scene, {.horizon = 1.0}, folder.path());
  ASSERT_TRUE(truth.smallest[ErrorKind::trajectory]) << truth.remark;
  const JudgedRun run = judge_run(scene.model, scene.start, truth, plan.settings);
  EXPECT_LE(*run.errors[ErrorKind::trajectory], wanted) << plan.why;
  EXPECT_EQ(plan.settings.values, plan_scene(scene, target, {}, folder.path()).settings.values);
}

INSTANTIATE_TEST_SUITE_P(SmallScenes, PlanTest,
                         ::testing::Values(std::pair("pendulum", 0.1), std::pair("pendulum", 0.01),
                                           std::pair("pendulum", 0.001), std::pair("chain-20", 0.1),
                                           std::pair("chain-20", 0.01), std::pair("chain-20", 0.001)));

TEST(Plan, KeepsToTheMethodThatIsAskedFor) {
  const Scene scene = scene_named("pendulum");
  const testing::TemporaryFolder folder;
  const Plan plan = plan_scene(scene, {ErrorKind::trajectory, 0.01, false}, "xpbd", folder.path());
  EXPECT_EQ(plan.settings.method, "xpbd");
  EXPECT_TRUE(plan.reached) << plan.why;
}

// Targets far enough apart that none is met by the plan of the one before.
TEST(Plan, AFinerTargetCostsMore) {
  const Scene scene = scene_named("chain-20");
  const testing::TemporaryFolder folder;
  double before = 0.0;
  for (const double wanted : {0.3, 0.01, 1e-3, 1e-4}) {
    const Plan plan = plan_scene(scene, {ErrorKind::trajectory, wanted, false}, {}, folder.path());
    EXPECT_GT(plan.predicted_seconds, before) << plan.why;
    before = plan.predicted_seconds;
  }
}

// Every method at every step that the plan could have had, by brute force.
TEST(Plan, IsNoDearerThanAnyRunThatIsGoodEnough) {
  const Scene scene = scene_named("chain-20");
  const testing::TemporaryFolder folder;
  constexpr double wanted = 0.01, well_within = 0.5 * wanted;
  const Plan plan = plan_scene(scene, {ErrorKind::trajectory, wanted, false}, {}, folder.path());
  const Truth truth = scene_truth(scene, {}, folder.path());
  int good = 0;
  for (const Curve& curve : curves_for(scene.model).curves)
    for (double rate = 60.0; rate <= 8000.0; rate *= 2.0) {
      const JudgedRun run = judge_run(scene.model, scene.start, truth, settings_at(curve, rate, 1));
      if (run.diverged || *run.errors[ErrorKind::trajectory] > well_within) continue;
      ++good;
      EXPECT_GE(predicted_seconds(scene.model, curve.settings.method, run.counts, rate * scene.duration),
                plan.predicted_seconds)
          << curve.name << " at " << rate << "; " << plan.why;
    }
  EXPECT_GT(good, 5);
}

}  // namespace
}  // namespace taut
