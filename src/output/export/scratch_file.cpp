#include "export/scratch_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "base/failure.h"

namespace taut {
namespace {

[[noreturn]] void scratch_fails(const std::filesystem::path& folder, int error) {
  throw RunFailure(fmt::format("can't keep what is to be written in {}: {}",
                               folder.empty() ? "the current folder" : folder.string(),
                               std::generic_category().message(error)));
}

}  // namespace

ScratchFile::ScratchFile(const std::filesystem::path& folder) : folder_(folder) {
  constexpr mode_t mine_alone = 0600;
  const std::filesystem::path place = folder_.empty() ? "." : folder_;
  descriptor_ = ::open(place.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, mine_alone);
  if (descriptor_ >= 0) return;
  // Not every file system knows files that never had a name.
  std::string name = (place / ".taut-scratch-XXXXXX").string();
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) scratch_fails(folder_, errno);
  ::unlink(name.c_str());
}

ScratchFile::~ScratchFile() {
  ::close(descriptor_);
}

void ScratchFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) scratch_fails(folder_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    size_ += static_cast<std::uint64_t>(written);
  }
}

void ScratchFile::copy(std::uint64_t offset, std::uint64_t size,
                       const std::function<void(std::string_view)>& write) const {
  constexpr std::uint64_t piece = 1 << 20;
  std::string buffer(std::min(size, piece), '\0');
  while (size > 0) {
    const ssize_t got =
        ::pread(descriptor_, buffer.data(), std::min<std::uint64_t>(size, piece), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) scratch_fails(folder_, got < 0 ? errno : EIO);
    write(std::string_view(buffer.data(), static_cast<std::size_t>(got)));
    offset += static_cast<std::uint64_t>(got);
    size -= static_cast<std::uint64_t>(got);
  }
}

}  // namespace taut
