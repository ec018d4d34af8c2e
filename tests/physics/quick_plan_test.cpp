// Plans by rule, of scenes whose truth is known: with the program, and drawn from a seed. TAUT_PLAN_TABLE=1
// prints a line a scene.

#include "measure/quick_plan.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "generated_scenes.h"
#include "measure/cost.h"
#include "measure/work_precision.h"
#include "scenes_of_the_program.h"
#include "study/scene_truth.h"
#include "temporary_folder.h"

namespace taut::test {
namespace {

constexpr std::uint32_t seed = 20261128;
constexpr double wanted = 0.1;

Truth truth_of(const Scene& scene, const std::filesystem::path& folder) {
  TruthRequest request;
  request.judged = wanted;
  request.certify_seconds = 0.2;
  request.agree_seconds = 0.2;
  return scene_truth(scene, request, folder);
}

double work_of(const Scene& scene, const Truth& truth, const Settings& settings, const JudgedRun& run) {
  return predicted_seconds(scene.model, settings.method, run.counts,
                           truth.horizon() * settings.steps_per_second());
}

// The cheapest point of the charts' grid that is good enough.
double cheapest(const Scene& scene, const Truth& truth) {
  const std::vector<MethodVariant> curves = variants_of(scene.model, scene.start).variants;
  GridWalk walk(scene.model, curves, truth, 0.2);
  double least = infinity;
  while (const std::optional<GridPoint> point = walk.next()) {
    const Settings settings = settings_at_place(curves[point->curve], point->fineness, point->row);
    const JudgedRun run = judge_run(scene.model, scene.start, truth, settings);
    walk.record(run);
    if (run.diverged || !(*run.errors[ErrorKind::trajectory] <= wanted)) continue;
    least = std::min(least, work_of(scene, truth, settings, run));
    walk.forbid_above(least);
  }
  return least;
}

struct Tally {
  int judged = 0, met = 0, compared = 0, cheap = 0, worse_in_silence = 0;
};

void judge_plan(const std::string& name, const Scene& scene, const std::filesystem::path& folder,
                Tally& tally) {
  const std::clock_t begin = std::clock();
  const Plan plan =
      quick_plan(scene.model, scene.start, scene.duration, {ErrorKind::trajectory, wanted, false});
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  Truth truth = truth_of(scene, folder);
  const bool table = std::getenv("TAUT_PLAN_TABLE") != nullptr;
  if (table)
    fmt::print("{:24} {:.2f} s  {:44} promised {:.4f} until {:.2f} of {:.2f}", name, seconds,
               settings_text(plan.settings), plan.estimated_error.value_or(-1.0), plan.judged_until,
               plan.duration);
  if (truth.smallest[ErrorKind::trajectory].value_or(infinity) > wanted) {
    if (table) fmt::print("  no truth: {}\n", truth.remark);
    return;
  }
  const JudgedRun run = judge_run(scene.model, scene.start, truth, plan.settings);
  const double error = run.errors[ErrorKind::trajectory].value_or(infinity);
  const double least = cheapest(scene, truth), work = work_of(scene, truth, plan.settings, run);
  const bool promised = plan.judged_until >= truth.horizon() * 0.999 && plan.reached;
  ++tally.judged;
  tally.met += error <= wanted ? 1 : 0;
  // What is cheapest for the part that the truth covers says little of what the rest needs.
  const bool comparable = truth.horizon() >= 0.9 * scene.duration;
  tally.compared += comparable ? 1 : 0;
  tally.cheap += comparable && work <= 5.0 * least ? 1 : 0;
  tally.worse_in_silence += promised && error > wanted ? 1 : 0;
  if (table)
    fmt::print("  error {:.4f} until {:.2f}  work {:.2f}{}{}\n", error, truth.horizon(), work / least,
               error > wanted ? (promised ? " BROKEN" : " missed") : "",
               comparable && work > 5.0 * least ? " DEAR" : "");
  std::fflush(stdout);
}

TEST(QuickPlans, KeepToATenthOfTheSizeAndCostLittleMoreThanTheCheapest) {
  const testing::TemporaryFolder folder;
  Tally tally;
  std::vector<std::pair<std::string, Scene>> scenes;
  for (const std::string& name : scene_names()) scenes.emplace_back(name, scene_called(name));
  for (const GeneratedScene& drawn : generated_scenes(seed))
    scenes.emplace_back(drawn.name, parse_scene(drawn.text, drawn.name + ".toml"));
  for (const auto& [name, scene] : scenes) judge_plan(name, scene, folder.path(), tally);
  EXPECT_GE(tally.judged, 40);
  EXPECT_GE(tally.met, 0.95 * tally.judged);
  EXPECT_EQ(tally.worse_in_silence, 0);
  EXPECT_GE(tally.cheap, 0.95 * tally.compared);
  fmt::print("{} judged, {} met; {} compared, {} cheap\n", tally.judged, tally.met, tally.compared,
             tally.cheap);
}

}  // namespace
}  // namespace taut::test
