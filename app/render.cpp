#include <memory>
#include <optional>
#include <string>

#include "base/failure.h"
#include "command_line.h"
#include "flags.h"
#include "frames/simulate.h"
#include "interrupted.h"
#include "output_flags.h"
#include "planning.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

struct RenderFlags {
  SceneFlags scene;
  OutputFlags output;
  PlanFlags plan;
  std::string motion;
};

// Only camera and look are the command line's: how it moves is settled.
int draw_motion(const RenderFlags& flags) {
  if (!flags.plan.accuracy.empty() || flags.output.certify)
    throw BadRequest("with --motion nothing is simulated: neither --accuracy nor --certify goes with it");
  if (!flags.output.slow.empty())
    throw BadRequest(
        "a motion has the moments that it was simulated for: taut simulate --slow makes more of them");
  const StoredMotion motion = open_motion(flags.motion);
  Scene scene = flags.scene.scene.empty()
                    ? scene_of_motion(motion, flags.motion, flags.scene.overrides())
                    : load(flags.scene.scene, flags.scene.overrides(), flags.output.quiet);
  require_same_motion(scene, motion);
  print_notes(scene, flags.output.quiet);
  flags.output.apply_to(scene);
  RenderRequest request = flags.output.request("out/" + scene.name);
  if (flags.output.rate.empty()) request.rate = parse_frame_rate("--fps", motion.manifest.frame_rate);
  request.motion = motion.reader;
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was written", [&] {
    return render_and_report({&scene, 1}, request, flags.output, interrupts);
  });
}

int render(const RenderFlags& flags) {
  if (!flags.motion.empty()) return draw_motion(flags);
  if (flags.scene.scene.empty())
    throw BadRequest("there is no scene to render: name a SCENE, or --motion FOLDER");
  Scene scene = load(flags.scene.scene, flags.scene.overrides(), flags.output.quiet);
  print_notes(scene, flags.output.quiet);
  flags.output.apply_to(scene);
  RenderRequest request = flags.output.request("out/" + scene.name);
  request.execution = on_threads(flags.scene.thread_count(flags.output.certify ? 2 : 1));
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was written", [&] {
    const std::optional<Plan> plan =
        settle_method(scene, flags.plan, flags.scene.method, flags.output.quiet, stop_test(interrupts),
                      picture_bytes(request.picture.render));
    if (plan) request.plan = plan_text(*plan);
    return render_and_report({&scene, 1}, request, flags.output, interrupts, plan);
  });
}

}  // namespace

void add_render(CommandLine& program) {
  Verb* verb = program.add_subcommand("render", "Simulate a scene and make frames and a film of it");
  const auto flags = std::make_shared<RenderFlags>();
  flags->scene.add_to(*verb, "; not needed with --motion");
  flags->scene.add_threads_to(*verb);
  flags->plan.add_to(*verb);
  add_certify(*verb, flags->output.certify);
  flags->output.add_to(*verb, "out/<scene>");
  verb->add_option("--motion", flags->motion,
                   "Draw what `taut simulate` left in this folder, with any camera and look, instead of "
                   "simulating")
      ->names_a(ValueKind::folder);
  verb->footer(
      "Running the same again goes on where it stopped, from the last checkpoint. Shards fill one folder "
      "together.\n\n"
      "Example:\n  taut render curtain --film curtain.mp4 --set world.drag=0.5");
  verb->action([flags] { return render(*flags); });
}

}  // namespace taut
