#include "study/plan_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/digits.h"
#include "measure/cost.h"
#include "study/scene_plan.h"

namespace taut {
namespace {

constexpr double search_seconds = 20.0;  // as --accuracy has it
constexpr double same_horizon = 0.99;

std::optional<double> cheapest(const Scene& scene, const Chart& chart, ErrorKind kind, double wanted) {
  std::optional<double> least;
  for (const ChartCase& done : chart.cases) {
    if (done.run.diverged || !done.run.errors[kind] || *done.run.errors[kind] > wanted) continue;
    const double work = predicted_seconds(scene.model, done.settings.method, done.run.counts,
                                          static_cast<double>(done.run.steps));
    if (!least || work < *least) least = work;
  }
  return least;
}

std::string short_settings(const Settings& settings) {
  std::string text = settings.chooses_steps()
                         ? fmt::format("`{}` {:g} m", settings.method, settings.number("tolerance"))
                         : fmt::format("`{}` {}/s", settings.method, settings.steps_per_second());
  if (const auto passes = settings.values.find("passes"); passes != settings.values.end())
    text += fmt::format(" × {}", settings.number("passes"));
  if (const auto order = settings.values.find("order"); order != settings.values.end())
    text += fmt::format(" order {}", settings.choice("order"));
  return text;
}

}  // namespace

std::vector<PlanVerdict> judge_plans(const Scene& scene, const Chart& chart, const StopTest& stop) {
  std::vector<PlanVerdict> verdicts;
  for (const double wanted : {0.1, 0.01, 0.001}) {
    PlanVerdict verdict;
    verdict.scene = scene.name;
    verdict.wanted = wanted;
    const PlanSearch search{{ErrorKind::trajectory, wanted, false}, {}, search_seconds, stop};
    verdict.plan = plan_scene(scene, search);
    const Truth truth = truth_for_plan(scene, search);
    verdict.kind = judging_kind(truth, ErrorKind::trajectory, wanted);
    verdict.until = truth.horizon();
    verdict.share = truth.horizon() / scene.duration;
    verdict.smallest = truth.smallest[verdict.kind].value_or(infinity);
    const JudgedRun run = judge_run(scene.model, scene.start, truth, verdict.plan.settings, stop);
    verdict.error = run.errors[verdict.kind].value_or(infinity);
    verdict.work = predicted_seconds(scene.model, verdict.plan.settings.method, run.counts,
                                     static_cast<double>(run.steps)) *
                   chart.truth.horizon() / truth.horizon();
    if (chart.truth.horizon() > same_horizon * truth.horizon())
      verdict.cheapest_work = cheapest(scene, chart, verdict.kind, wanted);
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

std::string plan_table(const std::vector<PlanVerdict>& verdicts) {
  std::string table =
      "| scene | wanted | judged by | until | of the run | plan | error | met | work ÷ cheapest charted "
      "|\n|---|---|---|---|---|---|---|---|---|\n";
  std::size_t to_the_end = 0, met = 0, in_part = 0, within = 0, compared = 0, cheap = 0;
  for (const PlanVerdict& verdict : verdicts) {
    table += fmt::format("| {} | {} % | {} | {:.3g} s | {:.0f} % | {} | ", verdict.scene,
                         100.0 * verdict.wanted, name_of(verdict.kind), verdict.until, 100.0 * verdict.share,
                         short_settings(verdict.plan.settings));
    if (!verdict.judged()) {
      table += fmt::format("can't be judged below {} | | |\n", percent(verdict.smallest));
      continue;
    }
    const bool whole = verdict.judged_to_the_end();
    const std::string verdict_text = !verdict.within() ? "no" : whole ? "yes" : "so far";
    const double ratio = verdict.cheapest_work ? verdict.work / *verdict.cheapest_work : infinity;
    table += fmt::format("{} | {} | {} |\n", percent(verdict.error), verdict_text,
                         verdict.cheapest_work ? two_digits(ratio) : "");
    (whole ? to_the_end : in_part) += 1;
    (whole ? met : within) += verdict.within() ? 1 : 0;
    compared += verdict.cheapest_work ? 1 : 0;
    cheap += ratio <= 2.0 ? 1 : 0;
  }
  return table +
         fmt::format(
             "\n{} of {} plans that can be judged to the end of their runs meet their target; {} of {} that "
             "can "
             "be judged in part are within it so far. {} of {} cost at most twice the cheapest charted point "
             "that meets it, where the chart looks as far as the plan.\n",
             met, to_the_end, within, in_part, cheap, compared);
}

}  // namespace taut
