#include "shard_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "output/atomic_file.h"

namespace taut {

namespace fs = std::filesystem;

std::vector<fs::path> shard_files(const fs::path& file) {
  std::vector<fs::path> files;
  std::error_code error;  // a folder that is not there has none
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const auto name = shard_file_name(entry.path().filename().string());
    if (name && name->file == file.filename()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

void take_over_shards(CaseStore& store, const fs::path& file, std::string_view inputs, bool overwrite) {
  for (const fs::path& left : shard_files(file)) {
    if (overwrite) {
      remove_file(left);
      continue;
    }
    const CaseStore cases(left, inputs, false);
    for (const auto& [key, result] : cases.results())
      if (key != end_of_shard && !store.has(key)) store.add(key, result);
  }
}

void mark_end(CaseStore& store, const Shard& shard) {
  if (!shard.all() && !store.has(end_of_shard)) store.add(std::string(end_of_shard), "true");
}

}  // namespace taut
