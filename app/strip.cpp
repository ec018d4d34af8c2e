#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/json_text.h"
#include "base/stop.h"
#include "command_line.h"
#include "exit_status.h"
#include "flags.h"
#include "frames/still.h"
#include "host/patience.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "planning.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

constexpr Size strip_panel{480, 360};

struct StripFlags {
  SceneFlags scene;
  PictureFlags picture;
  std::string count = "6", file;
  bool json = false, quiet = false;
};

int strip(const StripFlags& flags) {
  Scene scene = load(flags.scene.scene, flags.scene.overrides(), flags.quiet);
  print_notes(scene, flags.quiet);
  flags.picture.apply_to(scene);
  const std::vector<double> times = strip_times(scene, parse_number("--count", flags.count));
  const PictureSettings settings = flags.picture.settings(strip_panel);
  const Execution execution = on_threads(flags.scene.thread_count(0));
  std::optional<std::string> note;
  std::optional<Plan> plan;
  const InterruptWatch interrupts(end_at_once);
  const int status = unless_interrupted(interrupts, "nothing was written", [&] {
    plan = settle_method(scene, {}, flags.scene.method, flags.quiet, stop_test(interrupts));
    const Patience patience(stderr, flags.quiet, "at the pictures");
    note = make_strip(scene, times, settings, flags.file, execution, stop_test(interrupts));
    return exit_done;
  });
  if (status != exit_done) return status;
  if (flags.json) {
    nlohmann::ordered_json json{{"scene", scene.name}, {"times", times}, {"file", flags.file}};
    if (plan) json["plan"] = plan_to_json(*plan);
    if (note) json["note"] = *note;
    print_result("{}\n", json_text(json, 2));
  }
  if (!flags.quiet) tell("{}: {} pictures, in {}\n", scene.name, times.size(), flags.file);
  if (!flags.quiet && note) tell("taut: note: {}\n", *note);
  return exit_done;
}

}  // namespace

void add_strip(CommandLine& program) {
  Verb* verb =
      program.add_subcommand("strip", "Pictures of a scene from start to end, side by side in one file");
  const auto flags = std::make_shared<StripFlags>();
  flags->scene.add_to(*verb);
  flags->scene.add_threads_to(*verb);
  verb->add_option("--count", flags->count, "How many pictures")->capture_default_str();
  verb->add_option("-o,--output", flags->file, "The PNG file; replaced when it exists")
      ->names_a(ValueKind::file)
      ->required();
  flags->picture.captions = true;
  flags->picture.add_to(*verb);
  verb->add_flag("--json", flags->json, "Print what was made as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No messages but errors");
  verb->footer(
      "--size is that of one picture [480x360].\n\nExample:\n  taut strip hanging-chain --count 6 -o "
      "chain.png");
  verb->action([flags] { return strip(*flags); });
}

}  // namespace taut
