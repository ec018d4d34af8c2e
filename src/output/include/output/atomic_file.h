#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "base/abrupt_end.h"

namespace taut {

/// A file being written under a temporary name in its own folder, so that its own name never stands for half
/// of it. Goes away with the object unless commit() was called; that of a run that was killed is taken away
/// by sweep_leftovers().
class PendingFile {
 public:
  /// Creates the temporary file, empty. Throws RunFailure with the system's reason when it can't.
  explicit PendingFile(std::filesystem::path final_name);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& temporary_name() const { return temporary_; }
  const std::filesystem::path& final_name() const { return final_; }

  /// Writes all bytes to the end of the temporary file. Throws RunFailure with the system's reason.
  void write(std::span<const std::byte> bytes);
  /// Puts these bytes in the place of what the temporary file holds. Throws RunFailure with the system's
  /// reason.
  void replace(std::string_view text);
  /// Gives the file its own name, replacing what had it. Throws RunFailure with the system's reason.
  void commit();

 private:
  void create();

  std::filesystem::path final_, temporary_;
  int descriptor_ = -1;
  std::optional<AtAbruptEnd> goes_away_;
};

/// Writes a whole file at once: it is there complete, or as it was before. Throws RunFailure with the
/// system's reason.
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& file, std::string_view text);

/// Takes away the temporary files in a folder (empty: the current one) that no running process is writing, on
/// this machine or on another that shares the folder. What can't be taken away stays.
void sweep_leftovers(const std::filesystem::path& folder);

/// The size of a file in bytes. Throws RunFailure with the system's reason.
std::uintmax_t size_of_file(const std::filesystem::path& file);

/// Takes a file away that may have gone already. Throws RunFailure with the system's reason.
void remove_file(const std::filesystem::path& file);

/// Makes a folder and those above it, where missing, ready to be written into: it is swept of leftovers, too.
/// Throws RunFailure with the system's reason.
void make_folder(const std::filesystem::path& folder);

}  // namespace taut
