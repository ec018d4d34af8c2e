#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

namespace taut {

/// A ZIP archive of files that are stored as they are, written from front to back; of any size.
class ZipWriter {
 public:
  /// `write` takes the archive's bytes. Throws RunFailure where there is no memory.
  explicit ZipWriter(std::function<void(std::string_view)> write);
  ~ZipWriter();

  /// Begins a file of so many bytes, which write() then gives.
  void begin(std::string_view name, std::uint64_t size);
  void write(std::string_view bytes);
  /// After the last file.
  void finish();

 private:
  struct Archive;
  void check(long result);
  std::unique_ptr<Archive> archive_;
};

}  // namespace taut
