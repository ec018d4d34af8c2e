#pragma once

#include <filesystem>

#include "frames/verify.h"

namespace taut {

/// Whether a folder, or one below, holds charts, maps or a sag sheet, or what shards have left of them.
bool holds_study(const std::filesystem::path& folder);

/// Holds every file of them against what contents.json says of it: it is there, whole, and has the content it
/// was made with; a store of cases may have grown since. What shards left must be readable; which of them are
/// missing is named. Adds to what was found. Throws Interrupted.
void verify_study(const std::filesystem::path& folder, Verification& found, const StopTest& stop = {});

}  // namespace taut
