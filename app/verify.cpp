#include "frames/verify.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "command_line.h"
#include "exit_status.h"
#include "frames/frame_selection.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "verbs.h"

namespace taut {
namespace {

struct VerifyFlags {
  std::string output;
  bool deep = false, json = false, quiet = false;
};

int status_of(const Verification& found) {
  if (!found.faults.empty()) return exit_not_whole;
  return found.missing.empty() ? exit_done : exit_incomplete;
}

int verify_output(const VerifyFlags& flags) {
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was said yet", [&] {
    Progress progress(stderr, progress_style(stderr, flags.quiet), "frames");
    const Verification found = verify(flags.output, flags.deep, progress, stop_test(interrupts));
    if (flags.json)
      print_result("{}\n", nlohmann::ordered_json{{"output", flags.output},
                                                  {"whole", found.faults.empty()},
                                                  {"checked", found.checked},
                                                  {"faults", found.faults},
                                                  {"notes", found.notes},
                                                  {"frames_missing", found.missing}}
                               .dump(2));
    for (const std::string& fault : found.faults) tell("taut: {}: {}\n", flags.output, fault);
    if (!flags.quiet) {
      for (const std::string& note : found.notes) tell("taut: note: {}\n", note);
      if (!found.missing.empty())
        tell("taut: note: frames {} of the film were not made\n", selection_text(found.missing));
      tell("{}: {} checked{}, {}\n", flags.output, found.checked, flags.deep ? " and simulated again" : "",
           found.faults.empty() ? "whole" : fmt::format("{} faults", found.faults.size()));
    }
    return status_of(found);
  });
}

}  // namespace

void add_verify(CommandLine& program) {
  Verb* verb = program.add_subcommand("verify", "Is this output whole, and what its manifest says it is?");
  const auto flags = std::make_shared<VerifyFlags>();
  verb->add_option("OUTPUT", flags->output,
                   "A folder of frames or of a motion, or a film made without frames")
      ->names_a(ValueKind::file)
      ->required();
  verb->add_flag("--deep", flags->deep, "Also simulate it again and compare the state of every frame");
  verb->add_flag("--json", flags->json, "Print what was found as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "Say only what is wrong");
  verb->footer(
      "Status 5: something is not as it was made. Status 3: what is there is whole, and frames of the film "
      "are still to be made.\n\nExample:\n  taut verify out/curtain --deep");
  verb->action([flags] { return verify_output(*flags); });
}

}  // namespace taut
