#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/shard_file.h"
#include "host/shard.h"
#include "study/case_store.h"

namespace taut {

// A shard keeps its cases beside the file that all of them become: cases-2-of-4.jsonl beside cases.jsonl.

/// The key of the case that a shard adds when all others are done.
inline constexpr std::string_view end_of_shard = "end of the shard";

/// The files that shards have left beside a file, in the order of their names.
std::vector<std::filesystem::path> shard_files(const std::filesystem::path& file);

/// Takes over what shards have left beside a file; when that is begun anew, it goes away. Throws as CaseStore
/// does.
void take_over_shards(CaseStore& store, const std::filesystem::path& file, std::string_view inputs,
                      bool overwrite);

/// Adds the mark that a shard is done, once.
void mark_end(CaseStore& store, const Shard& shard);

}  // namespace taut
