#include "frames/simulate.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/json_text.h"
#include "command_line.h"
#include "exit_status.h"
#include "flags.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "measures_json.h"
#include "planning.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

struct SimulateFlags {
  SceneFlags scene;
  PlanFlags plan;
  std::string folder, metrics, rate = "30", slow;
  bool overwrite = false, json = false, quiet = false;
};

void print_json(const Scene& scene, const MotionRequest& request, const MotionOutcome& outcome) {
  nlohmann::ordered_json json{
      {"scene", scene.name},
      {"method", scene.settings.method},
      {"frames", {{"asked", outcome.asked}, {"there", outcome.there}, {"kept", outcome.kept}}},
      {"resumed_at_frame", outcome.resumed_at},
      {"folder", request.folder.string()},
      {"bytes", outcome.bytes},
      {"frames_per_second", request.rate.value()},
      {"seconds", outcome.seconds},
      {"inputs", outcome.inputs},
      {"last_state_hash", outcome.last_state_hash},
      {"stopped", outcome.stopped}};
  if (request.metrics) json["metrics"] = request.metrics->string();
  if (outcome.measures) json["measures"] = measures_to_json(*outcome.measures, scene);
  print_result("{}\n", json_text(json, 2));
}

void print_motion(const Scene& scene, const MotionRequest& request, const MotionOutcome& outcome) {
  tell("{}: {} of {} moments", scene.name, outcome.there, outcome.asked);
  if (outcome.kept > 0) tell(", {} of them there already", outcome.kept);
  if (outcome.resumed_at > 0) tell(", went on at frame {}", outcome.resumed_at);
  tell(", in {}, {:.1f} MB, {:.1f} s\n", request.folder.string(), 1e-6 * static_cast<double>(outcome.bytes),
       outcome.seconds);
}

int simulate_scene(const SimulateFlags& flags) {
  Scene scene = load(flags.scene.scene, flags.scene.overrides(), flags.quiet);
  print_notes(scene, flags.quiet);
  apply_slow(flags.slow, scene);
  MotionRequest request;
  request.folder = flags.folder.empty() ? "out/" + scene.name + "-motion" : flags.folder;
  request.rate = parse_frame_rate("--fps", flags.rate);
  if (!flags.metrics.empty()) request.metrics = flags.metrics;
  request.overwrite = flags.overwrite;
  request.execution = on_threads(flags.scene.thread_count(0));
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was written", [&]() -> int {
    const StopTest stop = stop_test(interrupts);
    const std::optional<Plan> plan = settle_method(scene, flags.plan, flags.scene.method, flags.quiet, stop);
    if (plan) request.plan = plan_text(*plan);
    Progress progress(stderr, progress_style(stderr, flags.quiet), "moments");
    const MotionOutcome outcome = simulate_motion(scene, request, progress, stop);
    if (flags.json) print_json(scene, request, outcome);
    if (!flags.quiet) print_motion(scene, request, outcome);
    if (!outcome.stopped) return exit_done;
    return report_interrupted(
        interrupts, fmt::format("{} of {} moments are there; running the same again goes on", outcome.there,
                                outcome.asked));
  });
}

}  // namespace

void add_simulate(CommandLine& program) {
  Verb* verb = program.add_subcommand("simulate",
                                      "The motion alone, to be drawn later or elsewhere by render --motion");
  const auto flags = std::make_shared<SimulateFlags>();
  flags->scene.add_to(*verb);
  flags->scene.add_threads_to(*verb);
  flags->plan.add_to(*verb);
  verb->add_option("-o,--output", flags->folder, "Folder for the motion [out/<scene>-motion]")
      ->names_a(ValueKind::folder);
  verb->add_option("--fps", flags->rate, "Moments per second of film, such as 30, 29.97 or 24000/1001")
      ->capture_default_str();
  add_metrics(*verb, flags->metrics);
  add_slow(*verb, flags->slow);
  verb->add_flag("--overwrite", flags->overwrite, "Replace a motion that is there already");
  verb->add_flag("--json", flags->json, "Print a summary as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No progress and no summary");
  verb->footer(
      "Running the same again goes on where it stopped, from the last checkpoint.\n\n"
      "Example:\n  taut simulate curtain -o motion\n  taut render --motion motion --set camera.orbit=30 "
      "--film "
      "curtain.mp4");
  verb->action([flags] { return simulate_scene(*flags); });
}

}  // namespace taut
