#include "output/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>

#include "base/failure.h"
#include "output/file_lock.h"

namespace taut {
namespace {

// Whoever held the name before may have taken the file away between our opening and our locking it.
bool still_has_its_name(int descriptor, const std::filesystem::path& file) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, std::string_view name) : file_(folder / name) {
  constexpr mode_t everyone_as_umask_allows = 0666;
  for (;;) {
    descriptor_ = ::open(file_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, everyone_as_umask_allows);
    if (descriptor_ >= 0 && lock_file(descriptor_, LockWait::a_while)) {
      if (still_has_its_name(descriptor_, file_)) {
        goes_away_.emplace([name = file_] { ::unlink(name.c_str()); });
        return;
      }
      ::close(descriptor_);
      continue;
    }
    const int error = errno;
    const bool held = descriptor_ >= 0 && error == EWOULDBLOCK;
    if (descriptor_ >= 0) ::close(descriptor_);
    if (held) throw RunFailure(fmt::format("another taut is working in {}", folder.string()));
    throw RunFailure(
        fmt::format("can't lock {}: {}", file_.string(), std::generic_category().message(error)));
  }
}

FolderLock::~FolderLock() {
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace taut
