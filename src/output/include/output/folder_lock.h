#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "base/abrupt_end.h"

namespace taut {

/// Holds a name in a folder for this process alone, as long as the object lives: two programs never work on
/// the same output at once. What a program that was killed held is free again.
class FolderLock {
 public:
  /// `name` is a file's, in the folder; it goes away with the object. Throws RunFailure where another
  /// program holds it, or the system's reason.
  FolderLock(const std::filesystem::path& folder, std::string_view name);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::optional<AtAbruptEnd> goes_away_;
};

}  // namespace taut
