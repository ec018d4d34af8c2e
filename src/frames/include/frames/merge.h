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
  bool metrics_made = false;
  std::vector<int> unmeasured;  ///< frames that no shard's metrics have, where metrics are asked for
};

/// What is to be made of the joined frames.
struct MergeWishes {
  std::optional<std::filesystem::path> film, metrics;
};

/// Whether a folder holds frames, of shards or not.
bool holds_frames(const std::filesystem::path& folder);

/// Joins the frames of shards, in one folder or in several, in `into`: files that lie elsewhere are copied,
/// the manifests become one. Every file is held against its hash first. Where no frame is missing, makes the
/// film that is wanted. Where none is missing in the shards' metrics of the same kind (.csv or .jsonl), joins
/// them in one file, row by row in the order of frames. Joining again changes nothing. Throws OutputConflict
/// where they were made from different inputs, RunFailure where something can't be written, and Interrupted.
MergedFrames merge_frames(std::span<const std::filesystem::path> folders, const std::filesystem::path& into,
                          const MergeWishes& wishes, const StopTest& stop = {});

}  // namespace taut
