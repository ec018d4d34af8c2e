#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace taut {

/// What joining the cases of shards came to, of one file that they become.
struct MergedCases {
  std::filesystem::path file;
  std::size_t shards = 0, count = 0;  ///< files of shards, and cases that are there now
  std::vector<std::string> holes;     ///< what is missing, a line a shard
};

/// Whether shards have left cases in one of the folders, or below.
bool holds_cases(std::span<const std::filesystem::path> folders);

/// What shards have left of one store of cases, named from the folder, as far as it can be read.
struct ShardsLeft {
  std::filesystem::path file;
  std::size_t shards = 0;           ///< files
  std::vector<std::string> holes;   ///< which shards are missing or not done
  std::vector<std::string> faults;  ///< which files are damaged
};

/// Looks at what shards have left in a folder and below. Changes nothing.
std::vector<ShardsLeft> shards_left(const std::filesystem::path& folder);

/// Joins the cases that shards of chart, stability and sag have left in folders, in the files of the same
/// names below `into`. The shards' files stay as they are, and joining again changes nothing. Throws
/// OutputConflict where they are of different inputs, RunFailure where something can't be written.
std::vector<MergedCases> merge_cases(std::span<const std::filesystem::path> folders,
                                     const std::filesystem::path& into);

}  // namespace taut
