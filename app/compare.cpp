#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "base/failure.h"
#include "base/split.h"
#include "command_line.h"
#include "flags.h"
#include "frames/colouring.h"
#include "interrupted.h"
#include "output_flags.h"
#include "verbs.h"

namespace taut {
namespace {

constexpr Size compared_panel{640, 480};
constexpr std::size_t most_methods = 9;

struct CompareFlags {
  std::string scene;
  std::vector<std::string> methods, sets;
  OutputFlags output;
};

// The scene as one method runs it: "xpbd:passes=4" is --method xpbd --set solve.passes=4.
Scene load_for(const CompareFlags& flags, const std::string& method) {
  const std::vector<std::string_view> parts = split(method, ':');
  std::vector<std::string> sets = flags.sets;
  for (std::size_t i = 1; i < parts.size(); ++i) sets.push_back(fmt::format("solve.{}", parts[i]));
  Scene scene = load(flags.scene, {sets, std::string(parts.front())}, flags.output.quiet);
  flags.output.apply_to(scene);
  // What the scene asks for may be left out of a picture; what the command line asks for may not.
  if (!flags.output.picture.colour.empty()) require_colours(scene);
  return scene;
}

int compare(const CompareFlags& flags) {
  if (flags.methods.size() < 2 || flags.methods.size() > most_methods)
    throw BadRequest(fmt::format(
        "--methods is a list of 2 to {} methods, such as euler,verlet:passes=4,rattle", most_methods));
  std::vector<Scene> scenes;
  for (const std::string& method : flags.methods) {
    if (std::ranges::count(flags.methods, method) > 1)
      throw BadRequest(fmt::format("--methods has {} twice", method));
    scenes.push_back(load_for(flags, method));
  }
  print_notes(scenes.front(), flags.output.quiet);
  const RenderRequest request =
      flags.output.request(fmt::format("out/{}-compared", scenes.front().name), compared_panel);
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was written",
                            [&] { return render_and_report(scenes, request, flags.output, interrupts); });
}

}  // namespace

void add_compare(CommandLine& program) {
  Verb* verb =
      program.add_subcommand("compare", "Run a scene by several methods, side by side in one picture");
  const auto flags = std::make_shared<CompareFlags>();
  verb->add_option("SCENE", flags->scene, "A scene file, or the bare name of one of `taut list scenes`")
      ->names_a(ValueKind::scene)
      ->required();
  verb->add_option("--methods", flags->methods,
                   "Two or more, with settings that differ from the scene's: euler,xpbd:passes=4,rattle")
      ->names_a(ValueKind::method)
      ->list("METHODS")
      ->required();
  add_sets(*verb, flags->sets);
  flags->output.picture.captions = true;
  flags->output.add_to(*verb, "out/<scene>-compared");
  verb->footer(
      "--size is that of one picture [640x480]. A method that fails stays where it was, and its picture says "
      "so.\n\nExample:\n  taut compare hanging-chain --methods euler,verlet,xpbd,rattle --film compared.mp4");
  verb->action([flags] { return compare(*flags); });
}

}  // namespace taut
