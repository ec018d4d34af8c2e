#pragma once

#include <filesystem>
#include <vector>

#include "frames/frame_folder.h"
#include "output/manifest.h"

namespace taut {

/// One of the manifests that are joined, and the folder that it lies in.
struct ShardFolder {
  std::filesystem::path folder;
  Manifest manifest;
};

/// Joins the metrics of parts that are of the same kind as `file` and as they were made: every frame's rows
/// as they stand, in the order of frames. Gives the frames that none has; then nothing is written. The
/// manifest of the folder, which is `into`, knows the file, and no more of those it was joined from; they
/// stay. Throws BadRequest where there are none of that kind, OutputConflict where their columns differ or
/// something else has the file's name, and RunFailure.
std::vector<int> merge_metrics(const std::vector<ShardFolder>& parts, FrameFolder& folder,
                               const std::filesystem::path& into, const std::filesystem::path& file);

}  // namespace taut
