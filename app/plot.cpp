#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "base/json_text.h"
#include "base/nearest.h"
#include "choices.h"
#include "command_line.h"
#include "exit_status.h"
#include "flags.h"
#include "frames/simulate.h"
#include "host/patience.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "moments.h"
#include "output/atomic_file.h"
#include "output/gnuplot.h"
#include "planning.h"
#include "study/metrics_plot.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

struct PlotFlags {
  SceneFlags scene;
  std::string motion, rate, file;
  std::vector<std::string> shown, paths;
  bool json = false, quiet = false;
};

// What is seen of a run: its metrics, or the ways of masses.
struct Seen {
  MetricsTable metrics;
  std::vector<std::vector<Vec3>> ways;
};

std::vector<std::size_t> masses_named(const Scene& scene, const std::vector<std::string>& names) {
  const std::vector<std::string>& all = scene.model.masses.name;
  std::vector<std::size_t> masses;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name);
    const std::vector<std::string_view> candidates(all.begin(), all.end());
    if (found == all.end()) {
      const std::string hint = did_you_mean(nearest_name(name, candidates));
      throw BadRequest(
          fmt::format("{} has no mass {}{}{}", scene.name, in_quotes(name), hint.empty() ? "" : "; ", hint));
    }
    masses.push_back(static_cast<std::size_t>(found - all.begin()));
  }
  return masses;
}

// A point for every moment of a motion, or for every frame at a rate.
std::vector<Instant> instants_of(const Scene& scene, const MotionReader* motion, FrameRate rate) {
  if (motion == nullptr) return chosen_instants({}, scene, rate);
  std::vector<Instant> instants;
  instants.reserve(motion->records().size());
  for (const auto& [frame, record] : motion->records()) instants.push_back({frame, record.time});
  return instants;
}

Seen see(const Scene& scene, MomentSource& source, const std::vector<Instant>& instants,
         const std::vector<std::size_t>& masses, const StopTest& stop) {
  Seen seen;
  seen.ways.resize(masses.size());
  for (const auto [frame, time] : instants) {
    const std::optional<State> state = source.at(time, stop);
    if (!state) throw Interrupted();
    for (std::size_t i = 0; i < masses.size(); ++i) seen.ways[i].push_back(state->position.at(masses[i]));
    if (masses.empty()) seen.metrics.rows.push_back(frame_metrics(scene, frame, source.measures()));
  }
  return seen;
}

// The name without the ending that either of the two files has.
fs::path stem_of(const PlotFlags& flags, const std::string& name) {
  fs::path stem = flags.file.empty() ? fmt::format("out/{}-plot", name) : flags.file;
  if (stem.extension() == ".png" || stem.extension() == ".svg") stem.replace_extension();
  return stem;
}

void write_figure(const PlotScript& script, const fs::path& stem, const PlotFlags& flags,
                  const StopTest& stop) {
  if (stem.has_parent_path()) make_folder(stem.parent_path());
  write_plot(script, stem, stop);
  if (flags.json)
    print_result("{}\n", json_text(nlohmann::ordered_json{{"png", stem.string() + ".png"},
                                                          {"svg", stem.string() + ".svg"}},
                                   2));
  else if (!flags.quiet)
    tell("{0}.png, {0}.svg\n", stem.string());
}

bool is_metrics_file(const std::string& what) {
  const fs::path file = what;
  return file.extension() == ".csv" || file.extension() == ".jsonl";
}

int plot_file(const PlotFlags& flags, const InterruptWatch& interrupts) {
  if (!flags.paths.empty())
    throw BadRequest("metrics hold no places: --path needs the scene, or --motion FOLDER");
  if (!flags.motion.empty() || !flags.scene.sets.empty() || !flags.scene.method.empty() ||
      !flags.rate.empty())
    throw BadRequest("metrics are plotted as they are: --motion, --set, --method and --fps need a scene");
  const std::string name = fs::path(flags.scene.scene).stem().string();
  const TimeFigure figure = metrics_figure(read_metrics(flags.scene.scene), name, flags.shown);
  return unless_interrupted(interrupts, "nothing was written", [&] {
    write_figure(figure_script(figure), stem_of(flags, name), flags, stop_test(interrupts));
    return exit_done;
  });
}

int plot_scene(const PlotFlags& flags, const InterruptWatch& interrupts) {
  std::optional<StoredMotion> motion;
  if (!flags.motion.empty()) motion = open_motion(flags.motion);
  Scene scene = flags.scene.scene.empty() ? scene_of_motion(*motion, flags.motion, flags.scene.overrides())
                                          : load(flags.scene.scene, flags.scene.overrides(), flags.quiet);
  if (motion) require_same_motion(scene, *motion);
  print_notes(scene, flags.quiet);
  const std::vector<std::size_t> masses = masses_named(scene, flags.paths);
  for (const std::string& name : flags.shown) require_metric_plot(name);
  const FrameRate rate = parse_frame_rate("--fps", flags.rate.empty() ? "60" : flags.rate);
  const Execution execution = on_threads(flags.scene.thread_count(0));
  return unless_interrupted(interrupts, "nothing was written", [&] {
    const StopTest stop = stop_test(interrupts);
    if (!motion) settle_method(scene, {}, flags.scene.method, flags.quiet, stop);
    const Patience patience(stderr, flags.quiet, "at the plot");
    const std::shared_ptr<const MotionReader> reader = motion ? motion->reader : nullptr;
    MomentSource source(scene, reader, execution);
    const Seen seen = see(scene, source, instants_of(scene, reader.get(), rate), masses, stop);
    const PlotScript script = masses.empty()
                                  ? figure_script(metrics_figure(seen.metrics, scene.title, flags.shown))
                                  : figure_script(path_figure(scene.title, flags.paths, seen.ways));
    write_figure(script, stem_of(flags, scene.name), flags, stop);
    return exit_done;
  });
}

int plot(const PlotFlags& flags) {
  if (flags.scene.scene.empty() && flags.motion.empty())
    throw BadRequest("there is nothing to plot: name a SCENE, a file of --metrics, or --motion FOLDER");
  if (!flags.paths.empty() && !flags.shown.empty())
    throw BadRequest("--path and --show are plots of their own: ask for one of them");
  require_gnuplot();
  const InterruptWatch interrupts(end_at_once);
  return is_metrics_file(flags.scene.scene) ? plot_file(flags, interrupts) : plot_scene(flags, interrupts);
}

}  // namespace

void add_plot(CommandLine& program) {
  Verb* verb = program.add_subcommand(
      "plot", "Energies, strain, sag, speed over time, or the ways of masses, as PNG and SVG");
  const auto flags = std::make_shared<PlotFlags>();
  flags->scene.add_to(*verb, ", or a file that --metrics wrote; not needed with --motion");
  flags->scene.add_threads_to(*verb);
  verb->add_option("--motion", flags->motion, "Plot what `taut simulate` left in this folder")
      ->names_a(ValueKind::folder);
  verb->add_option(
          "--show", flags->shown,
          fmt::format("Out of {} [what says something of the run]", fmt::join(metric_plot_names(), ",")))
      ->one_of(as_words(metric_plot_names()))
      ->list("NAMES");
  verb->add_option("--path", flags->paths, "The ways of these masses instead, such as rope.40,rope.20")
      ->list("MASSES");
  verb->add_option("--fps", flags->rate, "Points a second of film [60]");
  verb->add_option("-o,--output", flags->file,
                   "Name of the two files, with or without an ending; replaced when they exist "
                   "[out/<scene>-plot]")
      ->names_a(ValueKind::file);
  verb->add_flag("--json", flags->json, "Print the files' names as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No messages but errors");
  verb->footer(
      "Example:\n  taut render hanging-chain --metrics chain.csv\n  taut plot chain.csv -o chain\n  taut "
      "plot "
      "bola --path knot -o way");
  verb->action([flags] { return plot(*flags); });
}

}  // namespace taut
