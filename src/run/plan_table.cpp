#include "run/plan_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "measure/cost.h"

namespace taut {
namespace {

std::optional<double> cheapest(const Scene& scene, const Chart& chart, ErrorKind kind, double wanted) {
  std::optional<double> least;
  for (const ChartCase& done : chart.cases) {
    if (done.run.diverged || !done.run.errors[kind] || *done.run.errors[kind] > wanted) continue;
    const double work = predicted_seconds(scene.model, done.run.counts,
                                          chart.truth.horizon() * done.settings.steps_per_second());
    if (!least || work < *least) least = work;
  }
  return least;
}

std::string short_settings(const Settings& settings) {
  std::string text = fmt::format("`{}` {}/s", settings.method, settings.steps_per_second());
  if (const auto passes = settings.values.find("passes"); passes != settings.values.end())
    text += fmt::format(" × {}", settings.number("passes"));
  if (const auto order = settings.values.find("order"); order != settings.values.end())
    text += fmt::format(" order {}", settings.choice("order"));
  return text;
}

}  // namespace

std::vector<PlanVerdict> judge_plans(const Scene& scene, const Chart& chart) {
  std::vector<PlanVerdict> verdicts;
  for (const double wanted : {0.1, 0.01, 0.001}) {
    PlanVerdict verdict;
    verdict.scene = scene.name;
    verdict.wanted = wanted;
    verdict.plan =
        make_plan(scene.model, scene.start, scene.duration, {ErrorKind::trajectory, wanted, false});
    verdict.kind = chart.truth.smallest[ErrorKind::trajectory] ? ErrorKind::trajectory : ErrorKind::sag;
    const JudgedRun run = judge_run(scene.model, scene.start, chart.truth, verdict.plan.settings);
    verdict.error = run.errors[verdict.kind].value_or(infinity);
    verdict.work = predicted_seconds(scene.model, run.counts,
                                     chart.truth.horizon() * verdict.plan.settings.steps_per_second());
    verdict.cheapest_work = cheapest(scene, chart, verdict.kind, wanted);
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

std::string plan_table(const std::vector<PlanVerdict>& verdicts) {
  std::string table =
      "| scene | wanted | judged by | plan | error | met | work ÷ cheapest charted "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const PlanVerdict& verdict : verdicts) {
    const std::string ratio =
        verdict.cheapest_work ? fmt::format("{:.2g}", verdict.work / *verdict.cheapest_work) : "none charted";
    table += fmt::format("| {} | {} % | {} | {} | {:.2g} % | {} | {} |\n", verdict.scene,
                         100.0 * verdict.wanted, name_of(verdict.kind), short_settings(verdict.plan.settings),
                         100.0 * verdict.error, verdict.met() ? "yes" : "no", ratio);
  }
  const auto met = std::ranges::count_if(verdicts, &PlanVerdict::met);
  const auto cheap = std::ranges::count_if(verdicts, [](const PlanVerdict& verdict) {
    return verdict.cheapest_work && verdict.work <= 2.0 * *verdict.cheapest_work;
  });
  return table +
         fmt::format(
             "\n{} of {} plans meet their target; {} cost at most twice the cheapest charted point that "
             "does.\n",
             met, verdicts.size(), cheap);
}

}  // namespace taut
