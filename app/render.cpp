#include <memory>
#include <optional>

#include "command_line.h"
#include "flags.h"
#include "interrupted.h"
#include "output_flags.h"
#include "planning.h"
#include "verbs.h"

namespace taut {
namespace {

struct RenderFlags {
  SceneFlags scene;
  OutputFlags output;
  PlanFlags plan;
};

int render(const RenderFlags& flags) {
  Scene scene = load(flags.scene.scene, flags.scene.overrides(), flags.output.quiet);
  print_notes(scene, flags.output.quiet);
  flags.output.picture.apply_to(scene);
  RenderRequest request = flags.output.request("out/" + scene.name);
  request.execution = on_threads(flags.scene.thread_count(flags.output.certify ? 2 : 1));
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was written", [&] {
    const std::optional<Plan> plan =
        settle_method(scene, flags.plan, flags.scene.method, flags.output.quiet, stop_test(interrupts));
    if (plan) request.plan = plan_text(*plan);
    return render_and_report({&scene, 1}, request, flags.output, interrupts, plan);
  });
}

}  // namespace

void add_render(CommandLine& program) {
  Verb* verb = program.add_subcommand("render", "Simulate a scene and make frames and a film of it");
  const auto flags = std::make_shared<RenderFlags>();
  flags->scene.add_to(*verb);
  flags->scene.add_threads_to(*verb);
  flags->plan.add_to(*verb);
  add_certify(*verb, flags->output.certify);
  flags->output.add_to(*verb, "out/<scene>");
  verb->footer(
      "Running the same again goes on where it stopped.\n\n"
      "Example:\n  taut render curtain --film curtain.mp4 --set world.drag=0.5");
  verb->action([flags] { return render(*flags); });
}

}  // namespace taut
