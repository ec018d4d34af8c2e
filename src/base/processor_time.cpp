#include "base/processor_time.h"

#include <time.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace taut {

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of_threads(std::string_view beginning) {
  double seconds = 0.0;
  std::error_code error;  // a thread may end meanwhile
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", error)) {
    std::string name;
    std::getline(std::ifstream(thread.path() / "comm"), name);
    double nanoseconds = 0.0;
    if (name.starts_with(beginning) && std::ifstream(thread.path() / "schedstat") >> nanoseconds)
      seconds += 1e-9 * nanoseconds;
  }
  return seconds;
}

}  // namespace taut
