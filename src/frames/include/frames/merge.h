#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/stop.h"

namespace taut {

/// What joining the frames of shards came to.
struct MergedFrames {
  std::size_t count = 0;     ///< frames that are there and whole
  std::vector<int> missing;  ///< of the whole film
  bool film_made = false;
};

/// Whether a folder holds frames, of shards or not.
bool holds_frames(const std::filesystem::path& folder);

/// Joins the frames of shards, in one folder or in several, in `into`: files that lie elsewhere are copied,
/// the manifests become one. Every file is held against its hash first. Where no frame is missing, makes the
/// film that is wanted. Joining again changes nothing. Throws OutputConflict where they were made from
/// different inputs, RunFailure where something can't be written, and Interrupted.
MergedFrames merge_frames(std::span<const std::filesystem::path> folders, const std::filesystem::path& into,
                          const std::optional<std::filesystem::path>& film, const StopTest& stop = {});

}  // namespace taut
