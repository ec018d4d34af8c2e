#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "host/shard.h"

namespace taut {

/// The file that a shard makes in place of one that all shards become: cases-2-of-4.jsonl for cases.jsonl; of
/// the only one, the file itself.
std::filesystem::path shard_file(const std::filesystem::path& file, const Shard& shard);

/// What a shard's file is called, in parts.
struct ShardFileName {
  std::string file;  ///< that all become
  Shard shard;
};

/// The parts of a file's name; nothing where it is no shard's.
std::optional<ShardFileName> shard_file_name(const std::string& name);

}  // namespace taut
