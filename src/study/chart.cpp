#include "study/chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/failure.h"
#include "base/hash.h"
#include "base/json_text.h"
#include "base/stopwatch.h"
#include "chart_json.h"
#include "host/versions.h"
#include "measure/cost.h"
#include "model/measures.h"
#include "shard_files.h"
#include "study/case_store.h"
#include "study/reference_cache.h"
#include "study/scene_truth.h"

namespace taut {
namespace {

// Shares of the budget: of one run, so that some hundred cases fit; of all timed runs of one case.
constexpr double run_share = 1.0 / 200.0, case_share = 1.0 / 30.0;

// How long one run may take (s, predicted): in large scenes long enough for a row of doublings.
double longest_run(const Scene& scene, const Truth& truth, double budget) {
  constexpr double coarsest = 60.0, doublings = 9.0;  // 1/s
  return std::max(
      budget * run_share,
      std::exp2(doublings) * predicted_seconds(scene.model, "xpbd", coarsest * truth.horizon(), 1));
}

// The truth, with only those kinds of error that are wanted.
Truth wanted_truth(const Scene& scene, const ChartRequest& request, const StopTest& stop) {
  constexpr double patience = 40.0;  // s of one run, so that a large scene is charted over a time of some use
  TruthRequest wanted;
  wanted.stop = stop;
  if (scene.model.links.size() > large_scene) wanted.certify_seconds = patience;
  wanted.horizon = request.horizon;
  wanted.motion = request.errors.empty() ||
                  std::ranges::find(request.errors, ErrorKind::trajectory) != request.errors.end();
  Truth truth = scene_truth(scene, wanted);
  std::vector<std::string_view> missing;
  for (const ErrorKind kind : all_error_kinds) {
    const bool asked = std::ranges::find(request.errors, kind) != request.errors.end();
    if (asked && !truth.smallest[kind]) missing.push_back(name_of(kind));
    const bool usual = kind != ErrorKind::sag || !truth.certified;
    if (!(request.errors.empty() ? usual : asked)) truth.smallest[kind].reset();
  }
  if (!missing.empty())
    truth.remark +=
        fmt::format("{}not judged: {}", truth.remark.empty() ? "" : "; ", fmt::join(missing, ", "));
  return truth;
}

std::string inputs_of(const Scene& scene, const ChartRequest& request) {
  Hash hash;
  hash.add(physics_toml(scene))
      .add(physics_version())
      .add(judging_version())
      .add(std::span(&request.budget, 1));
  const double horizon = request.horizon.value_or(-1.0);
  hash.add(std::span(&horizon, 1));
  for (const ErrorKind kind : request.errors) hash.add(name_of(kind));
  return hash.hex();
}

std::string key_of(const MethodVariant& curve, const GridPoint& point) {
  std::string key =
      fmt::format("{}, {} {}", curve.name, curve.finer.param, curve.finer.value(point.fineness));
  if (curve.passes) key += fmt::format(", {} passes", curve.passes->value(point.row));
  return key;
}

// What is left out along a curve depends on that curve alone, so shards deal out curves.
std::vector<MethodVariant> share_of(std::vector<MethodVariant> curves, const Shard& shard) {
  std::vector<MethodVariant> share;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (shard.has(i)) share.push_back(std::move(curves[i]));
  return share;
}

ChartCase run_case(const Scene& scene, const Truth& truth, const Settings& settings, double budget) {
  ChartCase done;
  done.settings = settings;
  done.run = judge_run(scene.model, scene.start, truth, settings);
  if (!done.run.diverged)
    done.times = time_runs(scene.model, scene.start, settings, done.run.steps, budget * case_share);
  return done;
}

}  // namespace

double ChartCase::seconds() const {
  return times.processor.empty() ? infinity : *std::ranges::min_element(times.processor);
}

Chart measure_chart(const Scene& scene, const ChartRequest& request, const std::filesystem::path& store_file,
                    Progress& progress, const StopTest& stop) {
  Chart chart;
  chart.scene = scene.name;
  chart.title = scene.title;
  chart.masses = scene.model.masses.size();
  chart.links = scene.model.links.size();
  chart.size = scene_size(scene.model, scene.start);
  chart.energy_scale = energy_scale(scene.model, scene.start);
  chart.budget = request.budget;
  chart.machine = this_machine();
  MethodVariants curves = variants_of(scene.model, scene.start, request.methods, Choices::charted);
  chart.curves = share_of(std::move(curves.variants), request.shard);
  chart.omissions = std::move(curves.omissions);
  const std::string inputs = inputs_of(scene, request);
  CaseStore store(shard_file(store_file, request.shard), inputs, request.overwrite);
  if (request.shard.all()) take_over_shards(store, store_file, inputs, request.overwrite);
  chart.truth = wanted_truth(scene, request, stop);
  for (const ErrorKind kind : all_error_kinds)
    if (chart.truth.smallest[kind]) chart.errors.push_back(kind);
  if (chart.errors.empty())
    throw RunFailure(fmt::format("{}: no error can be judged: {}", scene.name, chart.truth.remark));

  GridWalk walk(scene.model, chart.curves, chart.truth, longest_run(scene, chart.truth, request.budget));
  const Stopwatch watch;
  progress.start(static_cast<int>(walk.counts().all()));
  while (const std::optional<GridPoint> point = walk.next()) {
    const MethodVariant& curve = chart.curves[point->curve];
    const std::string key = key_of(curve, *point);
    if (!store.has(key)) {
      chart.stopped = stop && stop();
      if (chart.stopped || watch.seconds() > request.budget) break;
      const Settings settings = settings_at_place(curve, point->fineness, point->row);
      store.add(key, json_text(case_to_json(run_case(scene, chart.truth, settings, request.budget))));
    }
    chart.cases.push_back(case_from_json(store.result(key), *point));
    walk.record(chart.cases.back().run);
    progress.update(static_cast<int>(walk.counts().done()));
  }
  chart.counts = walk.counts();
  if (chart.complete()) mark_end(store, request.shard);
  progress.finish();
  return chart;
}

}  // namespace taut
