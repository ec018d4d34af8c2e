#include "frames/shard_file.h"

#include "base/failure.h"

namespace taut {

namespace fs = std::filesystem;

fs::path shard_file(const fs::path& file, const Shard& shard) {
  return file.parent_path() / (file.stem().string() + shard.suffix() + file.extension().string());
}

std::optional<ShardFileName> shard_file_name(const std::string& name) {
  const fs::path path(name);
  const std::string stem = path.stem().string();
  const std::size_t of = stem.rfind("-of-");
  if (of == std::string::npos || of == 0) return std::nullopt;
  const std::size_t dash = stem.rfind('-', of - 1);
  if (dash == std::string::npos || dash == 0) return std::nullopt;
  try {
    const Shard shard = parse_shard(stem.substr(dash + 1, of - dash - 1) + "/" + stem.substr(of + 4));
    return ShardFileName{stem.substr(0, dash) + path.extension().string(), shard};
  } catch (const BadRequest&) {
    return std::nullopt;
  }
}

}  // namespace taut
