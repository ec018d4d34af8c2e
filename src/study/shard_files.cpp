#include "shard_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/failure.h"
#include "output/atomic_file.h"

namespace taut {

namespace fs = std::filesystem;

fs::path shard_file(const fs::path& file, const Shard& shard) {
  return file.parent_path() / (file.stem().string() + shard.suffix() + file.extension().string());
}

std::optional<ShardFileName> shard_file_name(const std::string& name) {
  const fs::path path(name);
  const std::string stem = path.stem().string();
  const std::size_t of = stem.rfind("-of-");
  if (path.extension() != ".jsonl" || of == std::string::npos || of == 0) return std::nullopt;
  const std::size_t dash = stem.rfind('-', of - 1);
  if (dash == std::string::npos || dash == 0) return std::nullopt;
  try {
    const Shard shard = parse_shard(stem.substr(dash + 1, of - dash - 1) + "/" + stem.substr(of + 4));
    return ShardFileName{stem.substr(0, dash) + ".jsonl", shard};
  } catch (const BadRequest&) {
    return std::nullopt;
  }
}

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
