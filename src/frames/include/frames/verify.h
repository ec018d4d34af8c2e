#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/stop.h"
#include "host/progress.h"

namespace taut {

/// What looking at output has found.
struct Verification {
  std::vector<std::string> faults;  ///< what is not as the manifest says, a line each
  std::vector<std::string> notes;   ///< what is allowed, and good to know
  std::size_t checked = 0;          ///< frames, or moments of a motion
  std::vector<int> missing;         ///< frames of the whole film that nothing was asked of yet
  std::vector<std::string> holes;   ///< of a study: what is still to be run, a line each
};

/// Whether a folder has a manifest of frames or of a motion, whole or not.
bool holds_manifest(const std::filesystem::path& folder);

/// Holds a folder of frames or of a motion, or a film, against its manifest: every file that it names is
/// there, whole, and has the content it says; the manifest agrees with itself; nothing lies beside that it
/// doesn't name. `deep`: also simulates again what it says, and compares the state of every frame. Throws
/// BadRequest where there is no manifest, and Interrupted.
Verification verify(const std::filesystem::path& output, bool deep, Progress& progress,
                    const StopTest& stop = {});

}  // namespace taut
