#include "frames/hidden_folder.h"

#include <fmt/format.h>

#include <system_error>

#include "base/failure.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

// The lock is a file, too, that goes with whoever holds it.
void remove_files(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::error_code kept;  // what stays is of no harm
    if (entry.is_regular_file(kept) && entry.path().extension() != ".lock") fs::remove(entry.path(), kept);
  }
}

}  // namespace

fs::path hidden_folder(const fs::path& output, std::string_view ending) {
  // The name of "out/frames/" is "frames".
  const fs::path named = output.has_filename() ? output : output.parent_path();
  return named.parent_path() / fmt::format(".{}.{}", named.filename().string(), ending);
}

std::unique_ptr<FolderLock> lock_unless_held(const fs::path& folder, std::string_view name) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return nullptr;
  try {
    return std::make_unique<FolderLock>(folder, name);
  } catch (const RunFailure&) {
    return nullptr;
  }
}

void remove_hidden_folder(const fs::path& folder, std::unique_ptr<FolderLock> lock) {
  remove_files(folder);
  lock.reset();
  std::error_code error;
  fs::remove(folder, error);
}

bool has_checkpoint(const fs::path& hidden) {
  std::error_code error;
  return fs::exists(hidden / hidden_checkpoint, error);
}

UselessGoesAway::UselessGoesAway(const fs::path& folder)
    : at_abrupt_end_([folder] {
        if (has_checkpoint(folder)) return;
        remove_files(folder);
        std::error_code error;
        fs::remove(folder, error);
      }) {}

}  // namespace taut
