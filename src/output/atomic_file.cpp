#include "output/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "base/failure.h"

namespace taut {
namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& file, int error) {
  throw RunFailure(fmt::format("can't write {}: {}", file.string(), std::generic_category().message(error)));
}

// One process writes a name only once at a time, so its number keeps two runs apart.
std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  return file.parent_path() / fmt::format(".{}.{}.part", file.filename().string(), ::getpid());
}

}  // namespace

PendingFile::PendingFile(std::filesystem::path final_name)
    : final_(std::move(final_name)), temporary_(temporary_beside(final_)) {
  constexpr mode_t everyone_as_umask_allows = 0666;
  descriptor_ =
      ::open(temporary_.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, everyone_as_umask_allows);
  if (descriptor_ < 0) cannot_write(final_, errno);
  goes_away_.emplace([name = temporary_] { ::unlink(name.c_str()); });
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

void PendingFile::commit() {
  // Some file systems report a full disk only when a file is closed.
  if (::close(std::exchange(descriptor_, -1)) != 0) cannot_write(final_, errno);
  if (::rename(temporary_.c_str(), final_.c_str()) != 0) cannot_write(final_, errno);
  goes_away_.reset();
  temporary_.clear();
}

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  PendingFile pending(file);
  pending.write(bytes);
  pending.commit();
}

void write_file(const std::filesystem::path& file, std::string_view text) {
  write_file(file, std::as_bytes(std::span(text)));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error) && !error)
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw RunFailure(fmt::format("can't make the folder {}: {}", folder.string(), error.message()));
}

}  // namespace taut
