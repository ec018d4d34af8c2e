#include "output/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/failure.h"
#include "output/file_lock.h"

namespace taut {
namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& file, int error) {
  throw RunFailure(fmt::format("can't write {}: {}", file.string(), std::generic_category().message(error)));
}

constexpr std::string_view temporary_ending = ".part";

// One process writes a name only once at a time, so its number keeps two runs apart.
std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  return file.parent_path() / fmt::format(".{}.{}{}", file.filename().string(), ::getpid(), temporary_ending);
}

// As temporary_beside() makes them.
bool is_temporary_name(std::string_view name) {
  if (!name.starts_with('.') || !name.ends_with(temporary_ending)) return false;
  name.remove_suffix(temporary_ending.size());
  const std::size_t dot = name.rfind('.');
  const std::string_view number = name.substr(dot + 1);
  return dot > 0 && !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
}

bool still_has_a_name(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

// False where it is being written, or can't be taken away; where the file system knows no locks nothing is
// ever swept.
bool sweep_unless_locked(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool swept = lock_file(descriptor, LockWait::none) && ::unlink(file.c_str()) == 0;
  ::close(descriptor);
  return swept;
}

// Some file systems say only when a file is closed that there was no room for it. This asks them, and keeps
// the file open, and so locked. The error; 0: all is well.
int error_at_close(int descriptor) {
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  return copy >= 0 && ::close(copy) == 0 ? 0 : errno;
}

}  // namespace

PendingFile::PendingFile(std::filesystem::path final_name)
    : final_(std::move(final_name)), temporary_(temporary_beside(final_)) {
  create();
  goes_away_.emplace([name = temporary_] { ::unlink(name.c_str()); });
}

void PendingFile::create() {
  constexpr mode_t everyone_as_umask_allows = 0666;
  for (;;) {
    descriptor_ =
        ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, everyone_as_umask_allows);
    if (descriptor_ < 0 && errno == EEXIST && sweep_unless_locked(temporary_)) continue;
    if (descriptor_ < 0) cannot_write(final_, errno);
    // Until it is locked a sweep may take it for a leftover.
    if (!lock_file(descriptor_, LockWait::for_ever) || still_has_a_name(descriptor_)) return;
    ::close(descriptor_);
  }
}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void PendingFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) cannot_write(final_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void PendingFile::replace(std::string_view text) {
  if (::ftruncate(descriptor_, 0) != 0 || ::lseek(descriptor_, 0, SEEK_SET) < 0) cannot_write(final_, errno);
  write(std::as_bytes(std::span(text)));
}

void PendingFile::commit() {
  if (const int error = error_at_close(descriptor_); error != 0) cannot_write(final_, error);
  if (::rename(temporary_.c_str(), final_.c_str()) != 0) cannot_write(final_, errno);
  goes_away_.reset();
  temporary_.clear();
  ::close(std::exchange(descriptor_, -1));
}

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  PendingFile pending(file);
  pending.write(bytes);
  pending.commit();
}

void write_file(const std::filesystem::path& file, std::string_view text) {
  write_file(file, std::as_bytes(std::span(text)));
}

void sweep_leftovers(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    if (is_temporary_name(entry->path().filename().native())) sweep_unless_locked(entry->path());
}

std::uintmax_t size_of_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw RunFailure(fmt::format("can't read {}: {}", file.string(), error.message()));
  return size;
}

void remove_file(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::remove(file, error);
  if (error) throw RunFailure(fmt::format("can't remove {}: {}", file.string(), error.message()));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error) && !error)
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw RunFailure(fmt::format("can't make the folder {}: {}", folder.string(), error.message()));
  sweep_leftovers(folder);
}

}  // namespace taut
