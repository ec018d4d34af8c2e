#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/failure.h"
#include "base/split.h"
#include "command_line.h"
#include "exit_status.h"
#include "flags.h"
#include "frames/colouring.h"
#include "host/progress.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "methods/registry.h"
#include "output/gnuplot.h"
#include "study/sag_files.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

constexpr Size sag_panel{380, 340};
constexpr int most_passes = 100000;

struct SagFlags {
  SceneFlags scene;
  PictureFlags picture;
  std::string passes = "1,2,4,8,16,32,64,128,256", folder, shard;
  bool json = false, quiet = false;
};

std::vector<int> parse_passes(const std::string& text) {
  std::vector<int> passes;
  for (const std::string_view part : split(text, ',')) {
    const double count = parse_number("--passes", part);
    if (!(count >= 1.0 && count <= most_passes) || count != static_cast<int>(count))
      throw BadRequest(fmt::format("--passes are whole numbers from 1 to {}, not {}", most_passes, part));
    passes.push_back(static_cast<int>(count));
  }
  return passes;
}

// verlet at the pace of a display, as the text has it in mind, unless the command line says otherwise.
SceneOverrides sag_overrides(const SceneFlags& flags) {
  SceneOverrides overrides = flags.overrides();
  if (!overrides.method) overrides.method = "verlet";
  const Method* method = find_method(*overrides.method);
  if (method == nullptr || find_param(*method, "steps_per_second") != nullptr)
    overrides.sets.insert(overrides.sets.begin(), "solve.steps_per_second=60");
  return overrides;
}

int sag(const SagFlags& flags) {
  SagRequest request;
  request.passes = parse_passes(flags.passes);
  request.shard = chosen_shard(flags.shard);
  Scene scene = load(flags.scene.scene, sag_overrides(flags.scene), flags.quiet);
  flags.picture.apply_to(scene);
  if (!flags.picture.colour.empty()) require_colours(scene);
  print_notes(scene, flags.quiet);
  const PictureSettings settings = flags.picture.settings(sag_panel);
  const std::string folder = flags.folder.empty() ? "out/" + scene.name + "-sag" : flags.folder;
  request.folder = folder;
  require_gnuplot();
  const InterruptWatch interrupts(end_at_once);
  Progress progress(stderr, progress_style(stderr, flags.quiet), "rest shapes");
  progress.start(static_cast<int>(request.passes.size()));
  std::optional<SagStudy> study;
  try {
    study = study_sag(
        scene, request, [&](int done) { progress.update(done); }, stop_test(interrupts));
  } catch (const Interrupted&) {
    progress.finish();
    return report_interrupted(interrupts, std::filesystem::exists(request.folder)
                                              ? "running the same again goes on"
                                              : "nothing was written");
  }
  progress.finish();
  if (!request.shard.all()) {
    if (!flags.quiet)
      tell("{}: {} shapes, in {}; run without --shard afterwards to draw\n", scene.name,
           study->entries.size(), folder);
    return exit_done;
  }
  const int written = unless_interrupted(interrupts, "not all was written", [&] {
    write_sag_files(scene, *study, settings, folder, stop_test(interrupts));
    return exit_done;
  });
  if (written != exit_done) return written;
  if (flags.json) print_result("{}", sag_json(scene, *study));
  if (!flags.quiet)
    tell("{}: exact sag {:.4f} m; with {} {} of {} {:.4f} m; in {}\n", scene.name, study->exact_sag,
         request.passes.back(), request.passes.back() == 1 ? "pass" : "passes", study->settings.method,
         study->entries[request.passes.size() - 1].sag, folder);
  return exit_done;
}

}  // namespace

void add_sag(CommandLine& program) {
  Verb* verb =
      program.add_subcommand("sag", "Where a scene comes to rest over passes, beside the exact shape");
  const auto flags = std::make_shared<SagFlags>();
  flags->scene.add_to(*verb);
  verb->add_option("--passes", flags->passes, "Passes over all links in each step")->capture_default_str();
  verb->add_option("-o,--output", flags->folder, "The folder [out/SCENE-sag]")->names_a(ValueKind::folder);
  add_shard(*verb, flags->shard, "run without it afterwards to draw");
  flags->picture.add_to(*verb);
  verb->add_flag("--json", flags->json, "Print the numbers as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No messages but errors");
  verb->footer(
      "Settles with verlet at 60 steps/s unless --method or --set steps_per_second=… say otherwise. --size "
      "is that of one panel [380x340].\n\nExample:\n  taut sag hanging-chain-two-pins -o sag");
  verb->action([flags] { return sag(*flags); });
}

}  // namespace taut
