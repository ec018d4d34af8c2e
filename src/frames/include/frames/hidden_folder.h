#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "base/abrupt_end.h"
#include "output/folder_lock.h"

namespace taut {

/// The hidden folder beside a file or folder that is being made, for what a program that was killed goes on
/// from: ".NAME.ENDING".
std::filesystem::path hidden_folder(const std::filesystem::path& output, std::string_view ending);

/// The lock of a folder by its name; null where the folder isn't there or another program works in it.
std::unique_ptr<FolderLock> lock_unless_held(const std::filesystem::path& folder, std::string_view name);

/// Takes a hidden folder that is locked away, with the files in it. What can't be taken away stays: it is of
/// no harm.
void remove_hidden_folder(const std::filesystem::path& folder, std::unique_ptr<FolderLock> lock);

/// What whoever goes on begins with, in such a folder.
inline constexpr std::string_view hidden_checkpoint = "checkpoint.bin";

/// Whether there is one: a folder without it is of no use once its program has ended.
bool has_checkpoint(const std::filesystem::path& hidden);

/// As long as this lives, a hidden folder that is of no use goes away when the program ends without
/// unwinding. To be made before the folder is locked.
class UselessGoesAway {
 public:
  explicit UselessGoesAway(const std::filesystem::path& folder);

 private:
  AtAbruptEnd at_abrupt_end_;
};

}  // namespace taut
