#include "host/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/failure.h"

namespace taut {
namespace {

[[noreturn]] void standard_output_failed(int error) {
  throw RunFailure(fmt::format("can't write to standard output: {}", std::generic_category().message(error)));
}

}  // namespace

void fill_standard_streams() {
  // The lowest free descriptor is the one that is opened, so these are filled in order.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) ::open("/dev/null", O_RDONLY);
}

void write_result(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) standard_output_failed(errno);
}

void finish_results() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) standard_output_failed(errno);
}

void show_text(std::FILE* stream, std::string_view text) {
  const std::size_t ignored = std::fwrite(text.data(), 1, text.size(), stream);
  static_cast<void>(ignored);
}

}  // namespace taut
