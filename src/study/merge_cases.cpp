#include "study/merge_cases.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <utility>

#include "base/failure.h"
#include "shard_files.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

struct ShardCases {
  Shard shard;
  fs::path file;
};

// The files of shards by the file that they become, named from the folder.
using Groups = std::map<fs::path, std::vector<ShardCases>>;

Groups groups_in(std::span<const fs::path> folders) {
  Groups groups;
  for (const fs::path& folder : folders)
    for (const auto& entry :
         fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied))
      if (const auto name = shard_file_name(entry.path().filename().string());
          name && is_case_file(entry.path()))  // metrics of shards are called alike
        groups[fs::relative(entry.path().parent_path(), folder) / name->file].push_back(
            {name->shard, entry.path()});
  return groups;
}

std::vector<std::string> holes_in(const std::vector<ShardCases>& shards) {
  std::vector<std::string> holes;
  const std::size_t count = shards.front().shard.count;
  for (std::size_t index = 1; index <= count; ++index) {
    bool there = false, done = false;
    for (const ShardCases& each : shards) {
      if (each.shard.index != index || each.shard.count != count) continue;
      there = true;
      done = done || read_cases(each.file, "").contains(end_of_shard);
    }
    if (!there) holes.push_back(fmt::format("shard {} of {} is missing", index, count));
    if (there && !done) holes.push_back(fmt::format("shard {} of {} is not done", index, count));
  }
  return holes;
}

MergedCases join(const fs::path& file, const std::vector<ShardCases>& shards) {
  const std::string inputs = inputs_of_cases(shards.front().file);
  MergedCases merged{file, shards.size(), 0, holes_in(shards)};
  CaseStore store(file, inputs, false);
  for (const ShardCases& each : shards) {
    const CaseStore cases(each.file, inputs, false);
    for (const auto& [key, result] : cases.results())
      if (key != end_of_shard && !store.has(key)) store.add(key, result);
  }
  merged.count = store.results().size();
  return merged;
}

}  // namespace

std::vector<ShardsLeft> shards_left(const fs::path& folder) {
  std::vector<ShardsLeft> all;
  for (const auto& [file, shards] : groups_in(std::array{folder})) {
    ShardsLeft left{file, shards.size(), {}, {}};
    for (const ShardCases& each : shards) {
      try {
        read_cases(each.file, "");
      } catch (const OutputConflict& damage) {
        left.faults.emplace_back(damage.what());
      }
    }
    if (left.faults.empty()) left.holes = holes_in(shards);
    all.push_back(std::move(left));
  }
  return all;
}

bool holds_cases(std::span<const fs::path> folders) {
  return !groups_in(folders).empty();
}

std::vector<MergedCases> merge_cases(std::span<const fs::path> folders, const fs::path& into) {
  std::vector<MergedCases> merged;
  for (const auto& [file, shards] : groups_in(folders)) merged.push_back(join(into / file, shards));
  return merged;
}

}  // namespace taut
