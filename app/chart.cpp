#include "study/chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/failure.h"
#include "choices.h"
#include "command_line.h"
#include "exit_status.h"
#include "flags.h"
#include "host/scene_folder.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "output/gnuplot.h"
#include "study/chart_files.h"
#include "study/chart_summary.h"
#include "study/plan_table.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

struct ChartFlags {
  std::vector<std::string> scenes, sets, methods, errors;
  std::string horizon, budget = "60s", folder = "out/chart", shard;
  bool all = false, plans = false, overwrite = false, draw_only = false, json = false, quiet = false;
};

ErrorKind parse_error(const std::string& text) {
  std::vector<std::string_view> names;
  for (const ErrorKind kind : all_error_kinds) {
    if (name_of(kind) == text) return kind;
    names.push_back(name_of(kind));
  }
  not_one_of("each of --errors", text, names);
}

std::vector<std::string> error_words() {
  std::vector<std::string> words;
  words.reserve(all_error_kinds.size());
  for (const ErrorKind kind : all_error_kinds) words.emplace_back(name_of(kind));
  return words;
}

double positive(std::string_view flag, const std::string& text) {
  const double seconds = parse_seconds(flag, text);
  if (seconds <= 0.0) throw BadRequest(fmt::format("{} must be more than 0 s", flag));
  return seconds;
}

ChartRequest request_from(const ChartFlags& flags) {
  ChartRequest request;
  request.methods = flags.methods;
  for (const std::string& error : flags.errors) request.errors.push_back(parse_error(error));
  if (!flags.horizon.empty()) request.horizon = positive("--horizon", flags.horizon);
  request.budget = positive("--budget", flags.budget);
  request.overwrite = flags.overwrite;
  request.shard = chosen_shard(flags.shard);
  if (!request.shard.all() && flags.plans)
    throw BadRequest("--plans needs the cases of all shards: run it without --shard afterwards");
  return request;
}

std::vector<Scene> load_all(const ChartFlags& flags) {
  std::vector<std::string> names = flags.scenes;
  if (flags.all)
    for (const std::filesystem::path& file : all_scene_files()) names.push_back(file.string());
  if (names.empty()) throw BadRequest("chart needs a scene, or --all");
  std::vector<Scene> scenes;
  for (const std::string& name : names) {
    scenes.push_back(load(name, {flags.sets, std::nullopt}, flags.quiet));
    print_notes(scenes.back(), flags.quiet);
    const std::string& scene = scenes.back().name;
    if (std::ranges::count(scenes, scene, &Scene::name) > 1)
      throw BadRequest(fmt::format("two scenes named {} would have the same files", scene));
  }
  return scenes;
}

void print_summary(const Chart& chart, const std::string& folder) {
  const GridWalk::Counts& counts = chart.counts;
  tell("{}: {} of {} cases ({} run, {} left out for adding nothing){}, in {}\n", chart.scene, counts.done(),
       counts.all(), counts.run, counts.left_out(),
       chart.complete() ? "" : "; running the same again goes on", folder);
}

// What charts there are, on one page and in tables.
void write_overviews(const std::vector<Chart>& charts, const std::filesystem::path& folder) {
  write_chart_page(charts, folder);
  write_chart_text("which-method.md", cheapest_method_table(charts) + "\n" + which_method_table(charts),
                   folder);
}

void print_json(const std::vector<Chart>& charts) {
  std::vector<std::string> parts(charts.size());
  std::ranges::transform(charts, parts.begin(), chart_json);
  print_result("[{}]\n", fmt::join(parts, ","));
}

// Draws what the folder holds, without a look at the scenes.
int draw_charts(const ChartFlags& flags) {
  if (flags.overwrite || flags.plans)
    throw BadRequest("--draw-only runs nothing: it goes with neither --overwrite nor --plans");
  const std::filesystem::path folder = flags.folder;
  std::vector<std::string> names = flags.scenes;
  if (flags.all)
    for (const std::filesystem::path& file : all_scene_files()) names.push_back(file.stem().string());
  if (names.empty()) throw BadRequest("chart needs a scene, or --all");
  require_gnuplot();
  std::vector<Chart> charts;
  int status = exit_done;
  for (const std::string& name : names) {
    const std::filesystem::path file = folder / (std::filesystem::path(name).stem().string() + ".json");
    std::ifstream stream(file);
    if (!stream)
      throw BadRequest(fmt::format("there is no {}: run the same without --draw-only", file.string()));
    charts.push_back(chart_from_json({std::istreambuf_iterator<char>(stream), {}}, file.string()));
    if (!charts.back().complete()) status = exit_incomplete;
  }
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "running the same again draws what is missing", [&] {
    for (const Chart& chart : charts) draw_chart(chart, folder, stop_test(interrupts));
    write_overviews(charts, folder);
    if (flags.json) print_json(charts);
    return status;
  });
}

int chart(const ChartFlags& flags) {
  if (flags.draw_only) return draw_charts(flags);
  const ChartRequest request = request_from(flags);
  const std::vector<Scene> scenes = load_all(flags);
  require_gnuplot();
  const InterruptWatch interrupts(end_at_once);
  const StopTest stop = stop_test(interrupts);
  std::vector<Chart> charts;
  std::vector<PlanVerdict> verdicts;
  int status = exit_done;
  try {
    for (const Scene& scene : scenes) {
      Progress progress(stderr, progress_style(stderr, flags.quiet), "cases");
      charts.push_back(measure_chart(scene, request,
                                     std::filesystem::path(flags.folder) / (scene.name + ".cases.jsonl"),
                                     progress, stop));
      stop_if_told(stop);
      // What is missing is the reason for the status, so it is said in any case.
      if (!flags.quiet || !charts.back().complete()) print_summary(charts.back(), flags.folder);
      if (request.shard.all()) write_chart(charts.back(), flags.folder, stop);
      if (!charts.back().complete()) status = exit_incomplete;
      if (flags.plans)
        std::ranges::move(judge_plans(scene, charts.back(), stop), std::back_inserter(verdicts));
    }
  } catch (const Interrupted&) {
    return report_interrupted(interrupts, "running the same again goes on, in " + flags.folder);
  }
  if (request.shard.all()) write_overviews(charts, flags.folder);
  if (flags.plans) write_chart_text("plans.md", plan_table(verdicts), flags.folder);
  if (flags.json) print_json(charts);
  return status;
}

}  // namespace

void add_chart(CommandLine& program) {
  Verb* verb =
      program.add_subcommand("chart", "Speed against accuracy: what each method needs for how little error");
  const auto flags = std::make_shared<ChartFlags>();
  verb->add_option("SCENE", flags->scenes, "Scene files, or bare names of `taut list scenes`")
      ->names_a(ValueKind::scene);
  verb->add_flag("--all", flags->all, "All scenes of `taut list scenes`");
  verb->add_flag("--plans", flags->plans,
                 "Also plan each scene for 10 %, 1 % and 0.1 % (see `taut render --accuracy`), and judge the "
                 "plans: plans.md");
  verb->add_option("--methods", flags->methods, "Only these, such as xpbd,rattle")
      ->names_a(ValueKind::method)
      ->list("METHODS");
  verb->add_option(
          "--errors", flags->errors,
          "Out of trajectory,strain,energy,sag [trajectory,strain,energy; sag, too, where no motion can be "
          "certified]")
      ->one_of(error_words())
      ->list("KINDS");
  verb->add_option("--horizon", flags->horizon, "Look at the scene until then, such as 1s [its duration]");
  verb->add_option("--budget", flags->budget,
                   "Time to spend on a scene; what is then missing is run the next time")
      ->capture_default_str();
  add_sets(*verb, flags->sets, "the scenes");
  verb->add_option("-o,--output", flags->folder, "Folder for charts, tables and chart.html")
      ->names_a(ValueKind::folder)
      ->capture_default_str();
  add_shard(*verb, flags->shard, "run without it afterwards to draw");
  verb->add_flag("--overwrite", flags->overwrite, "Replace what was measured there before");
  verb->add_flag(
      "--draw-only", flags->draw_only,
      "Run nothing, draw what SCENE.json in the folder says, whatever build has written it; status 3 where "
      "cases are missing");
  verb->add_flag("--json", flags->json, "Print an array of the charts' data as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No progress and no summary");
  verb->footer(
      "Every case is saved as it is done; running the same again goes on where it stopped. Status 3: the "
      "budget was "
      "spent before all cases were done.\n\n"
      "Example:\n  taut chart pendulum hanging-chain --methods xpbd,rattle --budget 30s");
  verb->action([flags] { return chart(*flags); });
}

}  // namespace taut
