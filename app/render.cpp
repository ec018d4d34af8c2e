#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "exit_status.h"
#include "flags.h"
#include "measures_json.h"
#include "planning.h"
#include "run/frames.h"
#include "run/signals.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

struct RenderFlags {
  SceneFlags scene;
  PictureFlags picture;
  std::string folder, film, selection, rate = "30", accuracy;
  bool no_frames = false, overwrite = false, json = false, quiet = false;
};

RenderRequest request_from(const RenderFlags& flags, const Scene& scene) {
  RenderRequest request;
  if (!flags.no_frames) request.folder = flags.folder.empty() ? "out/" + scene.name : flags.folder;
  if (!flags.film.empty()) request.film = flags.film;
  if (!flags.selection.empty()) request.selection = flags.selection;
  request.frames_per_second = parse_number("--fps", flags.rate);
  request.picture = flags.picture.settings();
  request.overwrite = flags.overwrite;
  return request;
}

void print_json(const Scene& scene, const RenderRequest& request, const RenderOutcome& outcome,
                const std::optional<Plan>& plan) {
  nlohmann::ordered_json json{
      {"scene", scene.name},
      {"method", scene.settings.method},
      {"frames", {{"asked", outcome.asked}, {"there", outcome.shown}, {"kept", outcome.kept}}},
      {"folder", nullptr},
      {"film", nullptr},
      {"width", request.picture.render.size.width},
      {"height", request.picture.render.size.height},
      {"frames_per_second", request.frames_per_second},
      {"seconds", outcome.seconds},
      {"inputs", outcome.inputs},
      {"last_state_hash", outcome.last_state_hash},
      {"stopped", outcome.stopped}};
  if (outcome.measures) json["measures"] = measures_to_json(*outcome.measures, scene.model);
  if (plan) json["plan"] = plan_to_json(*plan);
  if (request.folder) json["folder"] = request.folder->string();
  if (request.film && !outcome.stopped) json["film"] = request.film->string();
  fmt::print("{}\n", json.dump(2));
}

void print_summary(const Scene& scene, const RenderRequest& request, const RenderOutcome& outcome) {
  const std::string kept = outcome.kept > 0 ? fmt::format(", {} of them there already", outcome.kept) : "";
  fmt::print(stderr, "{}: {} of {} frames{}", scene.name, outcome.shown, outcome.asked, kept);
  if (request.folder) fmt::print(stderr, ", in {}", request.folder->string());
  if (request.film && !outcome.stopped) fmt::print(stderr, ", film in {}", request.film->string());
  if (request.film && outcome.stopped) fmt::print(stderr, ", no film");
  fmt::print(stderr, ", {}\n", duration_text(outcome.seconds));
}

int render(const RenderFlags& flags) {
  Scene scene = load(flags.scene.scene, flags.scene.overrides());
  flags.picture.apply_to(scene);
  RenderRequest request = request_from(flags, scene);
  const std::optional<Plan> plan = settle_method(scene, flags.accuracy, flags.scene.method, flags.quiet);
  if (plan) request.plan = plan->why;

  const InterruptWatch interrupts;
  Progress progress(stderr, progress_style(stderr, flags.quiet), "frames");
  const RenderOutcome outcome =
      render_frames(scene, request, progress, [&] { return interrupts.caught() != 0; });
  if (flags.json) print_json(scene, request, outcome, plan);
  if (!flags.quiet) print_summary(scene, request, outcome);
  if (plan && !flags.quiet) print_accuracy(*plan);
  return outcome.stopped ? exit_signal + interrupts.caught() : exit_done;
}

}  // namespace

void add_render(CLI::App& program, Action& action) {
  CLI::App* verb = program.add_subcommand("render", "Simulate a scene and make frames and a film of it");
  const auto flags = std::make_shared<RenderFlags>();
  flags->scene.add_to(*verb);
  verb->add_option("-o,--output", flags->folder, "Folder for the frames [out/<scene>]");
  verb->add_option("--film", flags->film, "Also make a film; its ending chooses .mp4, .webm, .gif or .webp");
  verb->add_flag("--no-frames", flags->no_frames, "Only the film, no PNG files");
  verb->add_option("--frames", flags->selection, "Only these frames, such as 1-100:2,150");
  flags->picture.add_to(*verb);
  add_accuracy(*verb, flags->accuracy);
  verb->add_option("--fps", flags->rate, "Frames per second")->capture_default_str();
  verb->add_flag("--overwrite", flags->overwrite, "Replace frames and a film that are there already");
  verb->add_flag("--json", flags->json, "Print a summary as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No progress and no summary");
  verb->footer(
      "Running the same again goes on where it stopped.\n\n"
      "Example:\n  taut render curtain --film curtain.mp4 --set world.drag=0.5");
  verb->callback([flags, &action] { action = [flags] { return render(*flags); }; });
}

}  // namespace taut
