#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "measure/cost.h"
#include "measure/pace.h"
#include "measure/work_precision.h"
#include "scenes_of_the_program.h"
#include "study/scene_plan.h"
#include "study/scene_truth.h"
#include "temporary_folder.h"

namespace taut::test {
namespace {

constexpr double search_seconds = 20.0;

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

// The runs of a grid against a truth, each judged once however often it is asked for.
class JudgedGrid {
 public:
  JudgedGrid(const Scene& scene, const Truth& truth)
      : scene_(scene), truth_(truth), curves_(variants_of(scene.model, scene.start).variants) {}

  // Whether any point that is predicted to cost less than that is good enough.
  bool any_cheaper_does(double wanted, double work) {
    for (std::size_t curve = 0; curve < curves_.size(); ++curve)
      for (int fineness = 0; fineness < curves_[curve].finer.count; ++fineness)
        for (int row = 0; row < (curves_[curve].relaxes() ? 5 : 1); ++row) {
          const GridPoint point{curve, fineness, row};
          const Settings settings = settings_at_place(curves_[curve], fineness, row);
          const double steps = truth_.horizon() * pace_of(scene_.model, settings);
          const auto passes =
              curves_[curve].relaxes() ? static_cast<std::int64_t>(settings.number("passes")) : 1;
          const std::string_view method = curves_[curve].settings.method;
          if (predicted_seconds(scene_.model, method, steps, passes) >= work) continue;
          const JudgedRun& run = at(point);
          if (!run.diverged && *run.errors[ErrorKind::trajectory] <= wanted &&
              predicted_seconds(scene_.model, method, run.counts, static_cast<double>(run.steps)) < work)
            return true;
        }
    return false;
  }

 private:
  const JudgedRun& at(const GridPoint& point) {
    const auto [place, is_new] = runs_.try_emplace({point.curve, point.fineness, point.row});
    if (is_new)
      place->second = judge_run(scene_.model, scene_.start, truth_,
                                settings_at_place(curves_[point.curve], point.fineness, point.row));
    return place->second;
  }

  const Scene& scene_;
  const Truth& truth_;
  std::vector<MethodVariant> curves_;
  std::map<std::tuple<std::size_t, int, int>, JudgedRun> runs_;
};

// What is true of a scene, as far as a target of this size needs to know it: the less, the further.
Truth truth_for(const Scene& scene, double wanted, const std::filesystem::path& folder) {
  TruthRequest request;
  request.judged = wanted;
  request.certify_seconds = 2.0;
  request.agree_seconds = 1.0;
  return scene_truth(scene, request, folder);
}

// The plan's run, judged against the true motion.
class PlanTest : public ::testing::TestWithParam<const char*> {};

TEST_P(PlanTest, MeetsItsTargetAndNothingHalfAsDearDoes) {
  const testing::TemporaryFolder folder;
  const Scene scene = scene_called(GetParam());
  for (const double wanted : {0.1, 0.01, 0.001}) {
    SCOPED_TRACE(wanted);
    const Truth truth = truth_for(scene, wanted, folder.path());
    ASSERT_FALSE(truth.states.empty()) << truth.remark;
    JudgedGrid grid(scene, truth);
    const AccuracyTarget target{ErrorKind::trajectory, wanted, false};
    const Plan plan = plan_scene(scene, {target, {}, search_seconds, {}}, folder.path());
    EXPECT_TRUE(plan.reached) << plan.why;
    ASSERT_LE(*truth.smallest[ErrorKind::trajectory], wanted) << truth.how;
    const JudgedRun run = judge_run(scene.model, scene.start, truth, plan.settings);
    EXPECT_LE(*run.errors[ErrorKind::trajectory], wanted) << plan.why;
    const double work =
        predicted_seconds(scene.model, plan.settings.method, run.counts, static_cast<double>(run.steps));
    EXPECT_FALSE(grid.any_cheaper_does(wanted, 0.5 * work)) << plan.why;
  }
}

INSTANTIATE_TEST_SUITE_P(SmallScenes, PlanTest,
                         ::testing::Values("pendulum", "chain-20", "level-chain", "hanging-chain",
                                           "hanging-chain-two-pins", "bridge"));

// By counts: what a plan itself predicts was measured, and so differs from build to build.
double work_of(const Scene& scene, const Truth& truth, const Settings& settings) {
  const JudgedRun run = judge_run(scene.model, scene.start, truth, settings);
  return predicted_seconds(scene.model, settings.method, run.counts, static_cast<double>(run.steps));
}

// The second time from the folder that plans are kept in: prices are measured, and may decide otherwise.
TEST(Plan, IsTheSameTwice) {
  const Scene scene = scene_called("chain-20");
  const testing::TemporaryFolder folder;
  const PlanSearch search{{ErrorKind::trajectory, 0.01, false}, {}, search_seconds, {}};
  const Plan first = plan_scene(scene, search, folder.path()),
             again = plan_scene(scene, search, folder.path());
  EXPECT_EQ(first.settings.values, again.settings.values);
  EXPECT_EQ(first.why, again.why);
  EXPECT_EQ(first.estimated_error, again.estimated_error);
  EXPECT_EQ(first.judged_until, again.judged_until);
  EXPECT_TRUE(again.searched);
}

TEST(Plan, KeepsToTheMethodThatIsAskedFor) {
  const Scene scene = scene_called("pendulum");
  const testing::TemporaryFolder folder;
  const Plan plan =
      plan_scene(scene, {{ErrorKind::trajectory, 0.01, false}, "xpbd", search_seconds, {}}, folder.path());
  EXPECT_EQ(plan.settings.method, "xpbd");
  EXPECT_TRUE(plan.reached) << plan.why;
}

// Targets far enough apart that none is met by the plan of the one before.
TEST(Plan, AFinerTargetCostsMore) {
  const Scene scene = scene_called("chain-20");
  const testing::TemporaryFolder folder;
  double before = 0.0;
  for (const double wanted : {0.3, 0.01, 1e-3, 1e-4}) {
    const Plan plan =
        plan_scene(scene, {{ErrorKind::trajectory, wanted, false}, {}, search_seconds, {}}, folder.path());
    const double work = work_of(scene, scene_truth(scene, {}, folder.path()), plan.settings);
    EXPECT_GT(work, before) << plan.why;
    before = work;
  }
}

// Every method at every step that the plan could have had, by brute force.
TEST(Plan, IsNoMoreThanTwiceAsDearAsAnyRunThatIsGoodEnough) {
  const Scene scene = scene_called("chain-20");
  const testing::TemporaryFolder folder;
  constexpr double wanted = 0.01, well_within = 0.5 * wanted;
  const Plan plan =
      plan_scene(scene, {{ErrorKind::trajectory, wanted, false}, {}, search_seconds, {}}, folder.path());
  const Truth truth = scene_truth(scene, {}, folder.path());
  const double work = work_of(scene, truth, plan.settings);
  int good = 0;
  for (const MethodVariant& curve : variants_of(scene.model, scene.start).variants)
    for (double rate = 60.0; rate <= 8000.0; rate *= 2.0) {
      const JudgedRun run =
          judge_run(scene.model, scene.start, truth, settings_at(scene.model, curve, rate, 1));
      if (run.diverged || *run.errors[ErrorKind::trajectory] > well_within) continue;
      ++good;
      EXPECT_GE(
          predicted_seconds(scene.model, curve.settings.method, run.counts, static_cast<double>(run.steps)),
          0.5 * work)
          << curve.name << " at " << rate << "; " << plan.why;
    }
  EXPECT_GT(good, 5);
}

}  // namespace
}  // namespace taut::test
