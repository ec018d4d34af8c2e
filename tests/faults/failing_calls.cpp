#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

// Loaded before the C library (LD_PRELOAD), makes the call fail that is number TAUT_FAULT_AT (from 1 on) of
// those that write in the program that was started: opening for writing, write, writev, close of what was
// opened so, rename, mkdir, ftruncate, fdatasync, fsync. The error is TAUT_FAULT_ERROR, a number. When that
// call is made, the file TAUT_FAULT_HIT appears. Programs that this one starts are left alone.

namespace {

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

long number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::atol(text);
}

std::atomic<long> calls{0};
constexpr int most_files = 1024;
std::atomic<bool> is_written[most_files];

// What the program starts is to go undisturbed.
[[gnu::constructor]] void leave_others_alone() {
  ::unsetenv("LD_PRELOAD");
}

// Whether this call is the one that is to fail.
bool fails() {
  static const long at = number_in("TAUT_FAULT_AT");
  if (at == 0 || ++calls != at) return false;
  const char* hit = std::getenv("TAUT_FAULT_HIT");
  const int file = next<int(const char*, int, ...)>("open")(hit, O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  if (file >= 0) next<int(int)>("close")(file);
  errno = static_cast<int>(number_in("TAUT_FAULT_ERROR"));
  return true;
}

bool writes(int flags) {
  return (flags & O_ACCMODE) != O_RDONLY;
}

// Files that count: what a program writes, and not the caches and devices of those below it.
bool counts(const char* path) {
  const std::string_view name(path);
  return !name.starts_with("/dev/") && !name.starts_with("/proc/") && !name.starts_with("/sys/");
}

int opened(int file) {
  if (file >= 0 && file < most_files) is_written[file] = true;
  return file;
}

bool is_ours(int file) {
  return file >= 0 && file < most_files && is_written[file];
}

using Open = int(const char*, int, ...);

int open_as(const char* name, const char* path, int flags, mode_t mode) {
  if (!writes(flags) || !counts(path)) return next<Open>(name)(path, flags, mode);
  return fails() ? -1 : opened(next<Open>(name)(path, flags, mode));
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open_as("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open_as("open64", path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t count) {
  if (is_ours(file) && fails()) return -1;
  return next<ssize_t(int, const void*, size_t)>("write")(file, bytes, count);
}

ssize_t writev(int file, const iovec* parts, int count) {
  if (is_ours(file) && fails()) return -1;
  return next<ssize_t(int, const iovec*, int)>("writev")(file, parts, count);
}

int fcntl(int file, int command, ...) {
  va_list more;
  va_start(more, command);
  void* const argument = va_arg(more, void*);
  va_end(more);
  const int result = next<int(int, int, ...)>("fcntl")(file, command, argument);
  if ((command == F_DUPFD || command == F_DUPFD_CLOEXEC) && is_ours(file)) opened(result);
  return result;
}

int close(int file) {
  const bool ours = is_ours(file);
  if (ours) is_written[file] = false;
  const bool fault = ours && fails();
  const int error = errno;
  const int result = next<int(int)>("close")(file);  // closed it is in any case
  if (!fault) return result;
  errno = error;
  return -1;
}

int rename(const char* from, const char* to) {
  return fails() ? -1 : next<int(const char*, const char*)>("rename")(from, to);
}

int mkdir(const char* path, mode_t mode) {
  return fails() ? -1 : next<int(const char*, mode_t)>("mkdir")(path, mode);
}

int ftruncate(int file, off_t length) {
  if (is_ours(file) && fails()) return -1;
  return next<int(int, off_t)>("ftruncate")(file, length);
}

int ftruncate64(int file, off64_t length) {
  if (is_ours(file) && fails()) return -1;
  return next<int(int, off64_t)>("ftruncate64")(file, length);
}

int fsync(int file) {
  if (is_ours(file) && fails()) return -1;
  return next<int(int)>("fsync")(file);
}

int fdatasync(int file) {
  if (is_ours(file) && fails()) return -1;
  return next<int(int)>("fdatasync")(file);
}
}
