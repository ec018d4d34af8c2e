#include "frames/verify.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/failure.h"
#include "base/json_text.h"
#include "command_line.h"
#include "exit_status.h"
#include "frames/frame_selection.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "study/verify_study.h"
#include "verbs.h"

namespace taut {
namespace {

struct VerifyFlags {
  std::string output;
  bool deep = false, json = false, quiet = false;
};

// A folder holds frames or a motion, or charts, maps and sag sheets.
Verification found_in(const VerifyFlags& flags, Progress& progress, const StopTest& stop) {
  if (!std::filesystem::is_directory(flags.output) || holds_manifest(flags.output) ||
      !holds_study(flags.output))
    return verify(flags.output, flags.deep, progress, stop);
  if (flags.deep)
    throw BadRequest(
        "--deep simulates frames again; the cases of charts, maps and sag sheets are run again by their own "
        "verbs, in another folder");
  Verification found;
  verify_study(flags.output, found, stop);
  return found;
}

int status_of(const Verification& found) {
  if (!found.faults.empty()) return exit_not_whole;
  return found.missing.empty() && found.holes.empty() ? exit_done : exit_incomplete;
}

int verify_output(const VerifyFlags& flags) {
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was said yet", [&] {
    Progress progress(stderr, progress_style(stderr, flags.quiet), "frames");
    const Verification found = found_in(flags, progress, stop_test(interrupts));
    if (flags.json)
      print_result("{}\n", json_text(nlohmann::ordered_json{{"output", flags.output},
                                                            {"whole", found.faults.empty()},
                                                            {"checked", found.checked},
                                                            {"faults", found.faults},
                                                            {"notes", found.notes},
                                                            {"frames_missing", found.missing},
                                                            {"holes", found.holes}},
                                     2));
    for (const std::string& fault : found.faults) tell("taut: {}: {}\n", flags.output, fault);
    if (!flags.quiet) {
      for (const std::string& note : found.notes) tell("taut: note: {}\n", note);
      for (const std::string& hole : found.holes) tell("taut: note: {}\n", hole);
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
  verb->add_option(
          "OUTPUT", flags->output,
          "A folder of frames, of a motion, of charts, maps or a sag sheet, or a film made without frames")
      ->names_a(ValueKind::file)
      ->required();
  verb->add_flag("--deep", flags->deep, "Also simulate it again and compare the state of every frame");
  verb->add_flag("--json", flags->json, "Print what was found as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "Say only what is wrong");
  verb->footer(
      "Status 5: something is not as it was made. Status 3: what is there is whole, and frames of the film, "
      "or cases of a study, are still to be made.\n\nExample:\n  taut verify out/curtain --deep");
  verb->action([flags] { return verify_output(*flags); });
}

}  // namespace taut
