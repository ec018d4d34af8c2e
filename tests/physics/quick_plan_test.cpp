// Plans by rule, of scenes whose truth is known: with the program, and drawn from a seed. TAUT_PLAN_TABLE=1
// prints a line a scene, TAUT_PLAN_SCENE=name takes that one alone.

#include "measure/quick_plan.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "generated_scenes.h"
#include "measure/cost.h"
#include "measure/work_precision.h"
#include "scenes_of_the_program.h"
#include "study/scene_plan.h"
#include "study/scene_truth.h"
#include "temporary_folder.h"

namespace taut::test {
namespace {

// TAUT_PLAN_SEED draws other scenes.
std::uint32_t seed() {
  const char* given = std::getenv("TAUT_PLAN_SEED");
  return given != nullptr ? static_cast<std::uint32_t>(std::stoul(given)) : 20261128U;
}
constexpr double wanted = 0.1;

Truth truth_of(const Scene& scene, const std::filesystem::path& folder) {
  TruthRequest request;
  request.judged = wanted;
  request.certify_seconds = 0.2;
  request.agree_seconds = 0.2;
  return scene_truth(scene, request, folder);
}

double work_of(const Scene& scene, const Settings& settings, const JudgedRun& run) {
  return predicted_seconds(scene.model, settings.method, run.counts, static_cast<double>(run.steps));
}

// The cheapest point of the charts' grid that is good enough.
double cheapest(const Scene& scene, const Truth& truth, double target) {
  const std::vector<MethodVariant> curves = variants_of(scene.model, scene.start).variants;
  GridWalk walk(scene.model, curves, truth, 0.2);
  double least = infinity;
  while (const std::optional<GridPoint> point = walk.next()) {
    const Settings settings = settings_at_place(curves[point->curve], point->fineness, point->row);
    const JudgedRun run = judge_run(scene.model, scene.start, truth, settings);
    walk.record(run);
    if (run.diverged || !(*run.errors[ErrorKind::trajectory] <= target)) continue;
    least = std::min(least, work_of(scene, settings, run));
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
  const double least = cheapest(scene, truth, wanted), work = work_of(scene, plan.settings, run);
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

// Those that are drawn, and those of the program.
std::vector<std::pair<std::string, Scene>> scenes_to_plan(bool all) {
  std::vector<std::pair<std::string, Scene>> scenes;
  if (all)
    for (const std::string& name : scene_names()) scenes.emplace_back(name, scene_called(name));
  for (const GeneratedScene& drawn : generated_scenes(seed()))
    scenes.emplace_back(drawn.name, parse_scene(drawn.text, drawn.name + ".toml"));
  if (const char* only = std::getenv("TAUT_PLAN_SCENE"))
    std::erase_if(scenes, [only](const auto& scene) { return scene.first != only; });
  return scenes;
}

TEST(QuickPlans, KeepToATenthOfTheSizeAndCostLittleMoreThanTheCheapest) {
  const testing::TemporaryFolder folder;
  Tally tally;
  for (const auto& [name, scene] : scenes_to_plan(true)) judge_plan(name, scene, folder.path(), tally);
  EXPECT_GE(tally.judged, 40);
  EXPECT_GE(tally.met, 0.95 * tally.judged);
  EXPECT_EQ(tally.worse_in_silence, 0);
  EXPECT_GE(tally.cheap, 0.95 * tally.compared);
  fmt::print("{} judged, {} met; {} compared, {} cheap\n", tally.judged, tally.met, tally.compared,
             tally.cheap);
}

// The cheapest point of the charts' grid, where the truth covers the whole run; else infinity.
double cheapest_of_the_whole(const Scene& scene, const Truth& truth, double target) {
  if (!reaches_the_end(truth.horizon(), scene.duration)) return infinity;
  return cheapest(scene, truth, target);
}

struct SearchTally {
  int to_the_end = 0, met = 0, broken = 0, compared = 0, cheap = 0;
};

void judge_search(const std::string& name, const Scene& scene, double target, double seconds,
                  const std::filesystem::path& folder, SearchTally& tally) {
  const PlanSearch search{{ErrorKind::trajectory, target, false}, {}, seconds, {}};
  const std::clock_t begin = std::clock();
  const Plan plan = plan_scene(scene, search, folder);
  const double spent = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const Truth truth = truth_for_plan(scene, search, folder);
  const bool table = std::getenv("TAUT_PLAN_TABLE") != nullptr;
  const bool judged = truth.smallest[ErrorKind::trajectory].value_or(infinity) <= target;
  const JudgedRun run = judged ? judge_run(scene.model, scene.start, truth, plan.settings) : JudgedRun{};
  const double error = run.errors[ErrorKind::trajectory].value_or(infinity);
  const bool promised =
      plan.reached && plan.kind == ErrorKind::trajectory && plan.judged_until >= 0.999 * truth.horizon();
  const bool whole = judged && reaches_the_end(truth.horizon(), scene.duration);
  tally.to_the_end += whole ? 1 : 0;
  tally.met += whole && error <= target ? 1 : 0;
  tally.broken += judged && promised && error > target ? 1 : 0;
  const double least = table && judged ? cheapest_of_the_whole(scene, truth, target) : infinity;
  const double ratio = work_of(scene, plan.settings, run) / least;
  tally.compared += least < infinity ? 1 : 0;
  tally.cheap += least < infinity && ratio <= 2.0 ? 1 : 0;
  if (!table) return;
  fmt::print("{:22} {:5} % {:5.1f} s  {:40} promised {:.5f} until {:.2f}  ", name, 100.0 * target, spent,
             settings_text(plan.settings), plan.estimated_error.value_or(-1.0), plan.judged_until);
  if (judged)
    fmt::print("error {:.5f} until {:.2f} of {:.2f}  work {:.2f}{}\n", error, truth.horizon(), scene.duration,
               ratio, error > target ? (promised ? " BROKEN" : " missed") : "");
  else
    fmt::print("can't be judged\n");
  std::fflush(stdout);
}

TEST(PlanSearches, MeetWhatCanBeJudgedToTheEnd) {
  const testing::TemporaryFolder folder;
  const bool all = std::getenv("TAUT_PLAN_TABLE") != nullptr;
  const std::vector<double> targets = all ? std::vector{0.1, 0.01, 0.001} : std::vector{0.01};
  SearchTally tally;
  for (const auto& [name, scene] : scenes_to_plan(all))
    for (const double target : targets)
      judge_search(name, scene, target, all ? 20.0 : 1.0, folder.path(), tally);
  fmt::print("{} judged to the end, {} met; {} compared, {} at most twice the cheapest\n", tally.to_the_end,
             tally.met, tally.compared, tally.cheap);
  EXPECT_GE(tally.to_the_end, 15);
  EXPECT_GE(tally.met, 0.98 * tally.to_the_end);
  EXPECT_EQ(tally.broken, 0);
}

}  // namespace
}  // namespace taut::test
