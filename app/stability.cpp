#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/failure.h"
#include "base/split.h"
#include "command_line.h"
#include "exit_status.h"
#include "flags.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "measure/stability_variant.h"
#include "methods/registry.h"
#include "output/gnuplot.h"
#include "study/stability_files.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

struct StabilityFlags {
  std::vector<std::string> scenes{"level-chain"}, sets, axes{"step,mass-ratio", "step,stiffness"};
  std::string methods, grid = "40x30", duration = "0.6", folder, shard;
  bool resume = false, overwrite = false, draw_only = false, json = false, quiet = false;
};

std::vector<std::string> axes_words() {
  std::vector<std::string> words;
  words.reserve(all_map_axes().size());
  for (const MapAxes& axes : all_map_axes()) words.emplace_back(axes.name);
  return words;
}

// All methods with a step to choose, or those of --methods. Throws BadRequest for one that is none, and for
// one that comes twice.
std::vector<MapMethod> chosen_methods(const std::string& list) {
  std::vector<MapMethod> chosen;
  if (list.empty()) {
    for (const Method& method : all_methods())
      if (!method.can.chooses_steps) chosen.push_back(parse_map_method(std::string(method.name)));
    return chosen;
  }
  for (const std::string_view part : split(list, ',')) {
    const std::string text(part);
    for (const MapMethod& other : chosen)
      if (other.label == text) throw BadRequest(fmt::format("--methods has {} twice", text));
    chosen.push_back(parse_map_method(text));
  }
  return chosen;
}

// A map of one scene over one pair of axes.
struct MapJob {
  Scene scene;
  StabilityRequest request;
  std::filesystem::path folder;
};

MapJob job_for(const StabilityFlags& flags, const std::string& scene, const std::string& axes) {
  MapJob job;
  job.scene = load(scene, {flags.sets, std::nullopt}, flags.quiet);
  const Size grid = parse_size("--grid", flags.grid);
  if (grid.width < 2 || grid.height < 2 || grid.width > 400 || grid.height > 400)
    throw BadRequest(fmt::format("--grid must be from 2x2 to 400x400, not {}", flags.grid));
  const double duration = parse_seconds("--duration", flags.duration);
  if (!(duration > 0.0)) throw BadRequest("--duration must be above 0 s");
  job.request.methods = chosen_methods(flags.methods);
  job.request.grid = make_map_grid(job.scene, find_map_axes(axes), grid.width, grid.height, duration);
  job.request.shard = chosen_shard(flags.shard);
  job.request.overwrite = flags.overwrite;
  job.request.run = !flags.draw_only;
  check_map_request(job.scene, job.request);
  std::string name = axes;
  std::replace(name.begin(), name.end(), ',', '-');
  const std::filesystem::path base = flags.folder.empty() ? "out/stability" : flags.folder;
  job.folder = base / job.scene.name / name;
  return job;
}

// Makes the maps of one job and draws them, unless they are only a shard's; gives the exit status.
int carry_out(const MapJob& job, const StabilityFlags& flags, const InterruptWatch& interrupts) {
  Progress progress(stderr, progress_style(stderr, flags.quiet), "columns");
  const StabilityMaps maps =
      make_stability_maps(job.scene, job.request, job.folder, progress, stop_test(interrupts));
  if (flags.json) print_result("{}", stability_json(maps, job.scene));
  const bool complete = maps.count.completed == maps.count.planned;
  // What is missing is the reason for the status, so it is said in any case.
  if (!flags.quiet || !complete)
    tell("{} {}: {} of {} columns{}, in {}\n", job.scene.name, job.request.grid.axes->name,
         maps.count.completed, maps.count.planned, complete ? "" : "; the others are still to be run",
         job.folder.string());
  if (maps.stopped) return report_interrupted(interrupts, "running the same again goes on");
  return unless_interrupted(interrupts, "running the same again draws what is missing", [&]() -> int {
    if (job.request.shard.all()) write_stability_files(maps, job.scene, job.folder, stop_test(interrupts));
    return complete ? exit_done : exit_incomplete;
  });
}

int stability(const StabilityFlags& flags) {
  if (flags.resume && flags.overwrite) throw BadRequest("--resume and --overwrite exclude each other");
  std::vector<MapJob> jobs;
  for (const std::string& scene : flags.scenes) {
    for (const std::string& axes : flags.axes) jobs.push_back(job_for(flags, scene, axes));
    print_notes(jobs.back().scene, flags.quiet);
  }
  require_gnuplot();
  const InterruptWatch interrupts(end_at_once);
  int status = exit_done;
  for (const MapJob& job : jobs) {
    const int ended = carry_out(job, flags, interrupts);
    if (interrupts.caught() != 0) return ended;
    status = std::max(status, ended);
  }
  return status;
}

}  // namespace

void add_stability(CommandLine& program) {
  Verb* verb = program.add_subcommand("stability", "Maps of where each method fails");
  const auto flags = std::make_shared<StabilityFlags>();
  verb->add_option("SCENE", flags->scenes, "Scene files, or bare names of `taut list scenes` [level-chain]")
      ->names_a(ValueKind::scene);
  verb->add_option("--methods", flags->methods,
                   "Only these, such as rattle,xpbd:passes=4,xpbd:precision=single [all]")
      ->names_a(ValueKind::method)
      ->with_commas();
  verb->add_option("--axes", flags->axes,
                   "step,mass-ratio  step,stiffness  step,links  passes,links  step,gravity; any number of "
                   "times [the first two]")
      ->one_of(axes_words())
      ->one_each("AXES");
  verb->add_option("--grid", flags->grid, "Columns x rows of a map")->capture_default_str();
  verb->add_option("--duration", flags->duration, "Seconds of every run, at most the scene's")
      ->capture_default_str();
  add_sets(*verb, flags->sets);
  verb->add_option("-o,--output", flags->folder, "Folder [out/stability]")->names_a(ValueKind::folder);
  verb->add_flag("--resume", flags->resume, "Go on where an earlier run stopped, as it does anyway");
  verb->add_flag("--overwrite", flags->overwrite, "Begin anew, whatever the folder holds");
  add_shard(*verb, flags->shard, "run without it afterwards to draw");
  verb->add_flag(
      "--draw-only", flags->draw_only,
      "Run nothing, draw what is there, whatever build has made it; status 3 where columns are missing");
  verb->add_flag("--json", flags->json, "Print the maps as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No progress and no summary");
  verb->footer(
      "Every run has the guard off: no step is halved. Light blue is where the energy held, dark red where "
      "it\n"
      "did not, each darker with the position error over the length of all links; hatched is what diverged "
      "or\n"
      "was refused; circles are the measured edge, the line is what theory predicts. overview.txt is the\n"
      "pictures' caption.\n\n"
      "Example:\n  taut stability level-chain --methods rattle,xpbd --axes step,mass-ratio");
  verb->action([flags] { return stability(*flags); });
}

}  // namespace taut
