#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "temporary_folder.h"

namespace taut::testing {

/// What a run of a program said, and how it ended.
struct Ran {
  int status = -1;  ///< exit status; 128 + signal when a signal ended it
  std::string out, err;
};

/// Changes to the environment of a program: name and value.
using Environment = std::vector<std::pair<std::string, std::string>>;

/// Runs a program to its end and collects what it says.
Ran run_program(const std::string& program, const std::vector<std::string>& arguments,
                const Environment& environment = {}, const std::filesystem::path& folder = {});

/// The same for taut itself.
Ran taut(const std::vector<std::string>& arguments, const Environment& environment = {},
         const std::filesystem::path& folder = {});

/// For a shell: waits until the process $process listens to SIGINT and SIGTERM, or is gone.
inline const std::string until_it_listens =
    "until grep -Eq '^SigCgt:.*[4567c-f]..[2367abef]$' /proc/$process/status\n"
    "do kill -0 $process || break; sleep 0.02; done\n";

/// A scene with one swinging mass that is quick to simulate and to draw: one second long.
std::string small_scene();

/// The same with a pin that jumps farther than its link is long: rattle can't turn a link by half a turn in a
/// step, xpbd can.
std::string scene_with_a_jumping_pin();

}  // namespace taut::testing
