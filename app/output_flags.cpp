#include "output_flags.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/failure.h"
#include "base/json_text.h"
#include "estimate.h"
#include "exit_status.h"
#include "frames/shard_file.h"
#include "host/machine.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "measures_json.h"
#include "output/film.h"
#include "planning.h"
#include "stages.h"
#include "values.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

// A method, and what came of it.
Json panel_to_json(const Scene& scene, const PanelOutcome& panel) {
  Json json{{"method", scene.settings.method}, {"measures", measures_to_json(panel.measures, scene)}};
  if (!panel.failure.empty()) json["failure"] = panel.failure;
  return json;
}

void print_json(std::span<const Scene> scenes, const RenderRequest& request, const RenderOutcome& outcome,
                const std::optional<Plan>& plan, const std::optional<Certificate>& certificate) {
  Json json{{"scene", scenes.front().name},
            {"method", scenes.front().settings.method},
            {"frames", {{"asked", outcome.asked}, {"there", outcome.shown}, {"kept", outcome.kept}}},
            {"resumed_at_frame", outcome.resumed_at},
            {"folder", nullptr},
            {"film", nullptr},
            {"width", outcome.size.width},
            {"height", outcome.size.height},
            {"frames_per_second", request.rate.value()},
            {"seconds", outcome.seconds},
            {"inputs", outcome.inputs},
            {"last_state_hash", outcome.last_state_hash},
            {"stopped", outcome.stopped}};
  if (scenes.size() > 1) {
    json.erase("method");
    json["methods"] = Json::array();
    for (std::size_t i = 0; i < outcome.panels.size(); ++i)
      json["methods"].push_back(panel_to_json(scenes[i], outcome.panels[i]));
  } else if (!outcome.panels.empty()) {
    json["measures"] = measures_to_json(outcome.panels.front().measures, scenes.front());
  }
  if (!outcome.stages.empty()) {
    json["drawn_by"] = outcome.drawn_by;
    json["stage_seconds"] = stages_to_json(outcome.stages);
  }
  if (plan) json["plan"] = plan_to_json(*plan);
  if (certificate) json["certificate"] = certificate_to_json(*certificate);
  if (outcome.note) json["note"] = *outcome.note;
  if (request.folder) json["folder"] = request.folder->string();
  if (request.film && !outcome.stopped) json["film"] = request.film->string();
  if (request.metrics) json["metrics"] = request.metrics->string();
  print_result("{}\n", json_text(json, 2));
}

void print_stages(const RenderOutcome& outcome) {
  if (outcome.drawn == 0) return;
  tell("drawn by {}\n{:.1f} frames/s; {}\n", outcome.drawn_by,
       static_cast<double>(outcome.drawn) / outcome.seconds, stages_text(outcome.stages, outcome.drawn));
}

void print_summary(std::span<const Scene> scenes, const RenderRequest& request,
                   const RenderOutcome& outcome) {
  const std::string kept = outcome.kept > 0 ? fmt::format(", {} of them there already", outcome.kept) : "";
  tell("{}: {} of {} frames{}", scenes.front().name, outcome.shown, outcome.asked, kept);
  if (outcome.resumed_at > 0) tell(", went on at frame {}", outcome.resumed_at);
  if (request.folder) tell(", in {}", request.folder->string());
  if (request.film && !outcome.stopped) tell(", film in {}", request.film->string());
  if (request.film && outcome.stopped) tell(", no film");
  tell(", {}\n", duration_text(outcome.seconds));
  if (outcome.note) tell("taut: note: {}\n", *outcome.note);
  for (std::size_t i = 0; i < outcome.panels.size(); ++i)
    if (const RunReport& report = outcome.panels[i].measures.report; report.worth_telling())
      tell("taut: note: {}: {}\n", scenes[i].settings.method, halving_sentence(scenes[i].model, report));
}

// What went wrong is said in any case.
void print_failures(std::span<const Scene> scenes, const RenderOutcome& outcome) {
  for (std::size_t i = 0; i < outcome.panels.size(); ++i)
    if (!outcome.panels[i].failure.empty())
      tell("taut: the panel of {} went no further: {}\n", scenes[i].settings.method,
           outcome.panels[i].failure);
}

int parse_depth(const std::string& text) {
  if (text.empty() || text == "8") return 8;
  if (text == "16") return 16;
  throw BadRequest(fmt::format("--depth is 8 or 16 bits a channel, not \"{}\"", text));
}

}  // namespace

void OutputFlags::add_to(Verb& verb, const std::string& usual_folder) {
  verb.add_option("-o,--output", folder, fmt::format("Folder for the frames [{}]", usual_folder))
      ->names_a(ValueKind::folder);
  verb.add_option("--film", film,
                  "Also make a film; its ending chooses .mp4, .webm, .gif, .webp or .mov (ProRes 4444, for "
                  "cutting), and - "
                  "is standard output (as .mp4; webm:- and gif:- otherwise)")
      ->names_a(ValueKind::file);
  add_metrics(verb, metrics);
  verb.add_flag("--no-frames", no_frames, "Only the film, no PNG files");
  verb.add_option("--frames", selection,
                  "Only these frames, such as 1-100:2,150; a film of every n-th keeps its speed");
  picture.add_to(verb);
  verb.add_option("--fps", rate, "Frames per second, such as 30, 29.97 or 24000/1001 [30]");
  add_slow(verb, slow);
  verb.add_option(
          "--depth", depth,
          "Bits of a colour channel: 8, in PNG files, or 16, in TIFF files and finer in .mov films [8]")
      ->one_of({"8", "16"});
  add_shard(verb, shard, "taut merge joins them");
  verb.add_flag("--overwrite", overwrite, "Replace frames and a film that are there already");
  verb.add_flag("--json", json, "Print a summary as JSON on stdout");
  verb.add_flag("-v,--verbose", verbose, "Also say what drew, and where the time went");
  verb.add_flag("--quiet", quiet, "No progress and no summary");
}

void OutputFlags::apply_to(Scene& scene) const {
  picture.apply_to(scene);
  apply_slow(slow, scene);
}

RenderRequest OutputFlags::request(const std::string& usual_folder, std::optional<Size> usual) const {
  RenderRequest request;
  if (!no_frames) request.folder = folder.empty() ? usual_folder : folder;
  if (!film.empty()) request.film = film;
  if (!selection.empty()) request.selection = selection;
  request.rate = rate.empty() ? FrameRate{} : parse_frame_rate("--fps", rate);
  request.shard = chosen_shard(shard);
  if (!metrics.empty()) request.metrics = shard_file(metrics, request.shard);
  request.picture = picture.settings(usual);
  request.picture.render.bits = parse_depth(depth);
  if (json && goes_to_standard_output(film))
    throw BadRequest("--film and --json can't both write to standard output");
  request.overwrite = overwrite;
  request.cores = static_cast<int>(this_machine().threads);
  return request;
}

int render_and_report(std::span<Scene> scenes, const RenderRequest& request, const OutputFlags& flags,
                      const InterruptWatch& interrupts, const std::optional<Plan>& plan) {
  Progress progress(stderr, progress_style(stderr, flags.quiet), "frames");
  const StopTest stop = stop_test(interrupts);
  std::optional<Certifier> certifier;
  RenderRequest watched = request;
  if (flags.certify) {
    certifier.emplace(scenes.front(), stop);
    watched.watch = [&](const State& state) { certifier->see(state); };
  }
  if (!flags.quiet)
    watched.foretell = [&](std::size_t frames, double seconds) {
      const std::string note = drawing_note(frames, seconds);
      if (!note.empty()) tell("taut: {}: note: {}\n", scenes.front().name, note);
    };
  const RenderOutcome outcome = render_frames(scenes, watched, progress, stop);
  std::optional<Certificate> certificate;
  const int certified = unless_interrupted(interrupts, "all frames are there, but no certificate", [&] {
    // Where every frame was there already nothing was simulated.
    if (flags.certify && !outcome.stopped)
      certificate = outcome.panels.empty() ? certify(scenes.front(), stop) : certifier->finish();
    return exit_done;
  });
  if (certified != exit_done) return certified;
  if (flags.json) print_json(scenes, request, outcome, plan, certificate);
  if (!flags.quiet) print_summary(scenes, request, outcome);
  if (flags.verbose && !flags.quiet) print_stages(outcome);
  if (plan && !flags.quiet) print_accuracy(*plan);
  if (certificate && !flags.quiet) print_certificate(*certificate);
  print_failures(scenes, outcome);
  if (!outcome.stopped) return exit_done;
  return report_interrupted(interrupts,
                            fmt::format("{} of {} frames are there{}{}", outcome.shown, outcome.asked,
                                        request.film ? ", and no film" : "",
                                        outcome.goes_on ? "; running the same again goes on" : ""));
}

}  // namespace taut
