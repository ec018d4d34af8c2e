#include "frames/still.h"

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
#include "host/patience.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "planning.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

struct StillFlags {
  SceneFlags scene;
  PictureFlags picture;
  std::string at, file;
  bool json = false, quiet = false;
};

int still(const StillFlags& flags) {
  Scene scene = load(flags.scene.scene, flags.scene.overrides(), flags.quiet);
  print_notes(scene, flags.quiet);
  flags.picture.apply_to(scene);
  const double time = flags.at.empty() ? scene.duration : parse_seconds("--at", flags.at);
  const PictureSettings settings = flags.picture.settings();
  const Execution execution = on_threads(flags.scene.thread_count(0));
  std::optional<std::string> note;
  std::optional<Plan> plan;
  const InterruptWatch interrupts(end_at_once);
  const int status = unless_interrupted(interrupts, "nothing was written", [&] {
    plan = settle_method(scene, {}, flags.scene.method, flags.quiet, stop_test(interrupts));
    const Patience patience(stderr, flags.quiet, "at the picture");
    note = make_still(scene, time, settings, flags.file, execution, stop_test(interrupts));
    return exit_done;
  });
  if (status != exit_done) return status;
  if (flags.json) {
    nlohmann::ordered_json json{{"scene", scene.name}, {"time", time}, {"file", flags.file}};
    if (plan) json["plan"] = plan_to_json(*plan);
    if (note) json["note"] = *note;
    print_result("{}\n", json_text(json, 2));
  }
  if (!flags.quiet) tell("{}: {} s, in {}\n", scene.name, time, flags.file);
  if (!flags.quiet && note) tell("taut: note: {}\n", *note);
  return exit_done;
}

}  // namespace

void add_still(CommandLine& program) {
  Verb* verb = program.add_subcommand("still", "One picture of a scene at a time");
  const auto flags = std::make_shared<StillFlags>();
  flags->scene.add_to(*verb);
  flags->scene.add_threads_to(*verb);
  verb->add_option("--at", flags->at, "The time, such as 2.5s or 500ms [the end]");
  verb->add_option("-o,--output", flags->file, "The PNG file; replaced when it exists")
      ->names_a(ValueKind::file)
      ->required();
  flags->picture.add_to(*verb);
  verb->add_flag("--json", flags->json, "Print what was made as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No messages but errors");
  verb->footer("Example:\n  taut still curtain --at 2.5s -o curtain.png");
  verb->action([flags] { return still(*flags); });
}

}  // namespace taut
