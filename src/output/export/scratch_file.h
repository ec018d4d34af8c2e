#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

namespace taut {

/// A file without a name for what is too much to keep in memory. It is gone with the object, however the
/// program ends.
class ScratchFile {
 public:
  /// In a folder (empty: the current one). Throws RunFailure with the system's reason.
  explicit ScratchFile(const std::filesystem::path& folder);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  std::uint64_t size() const { return size_; }  ///< bytes
  /// Adds bytes at the end. Throws RunFailure with the system's reason.
  void append(std::string_view bytes);
  /// Hands so many bytes from an offset on to `write`, in pieces. Throws RunFailure with the system's reason.
  void copy(std::uint64_t offset, std::uint64_t size,
            const std::function<void(std::string_view)>& write) const;

 private:
  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace taut
