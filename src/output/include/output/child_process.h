#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/abrupt_end.h"
#include "base/stop.h"

namespace taut {

/// Where a program is on the PATH; nothing when it is not installed.
std::optional<std::filesystem::path> find_program(std::string_view name);

/// How a child process ended and the last of what it said on its standard error.
struct ProcessEnd {
  int status = 0;          ///< exit status; 128 + signal when a signal ended it
  int signal = 0;          ///< that ended it; 0: none did
  std::string last_lines;  ///< at most the last 2,000 characters
  double processor_seconds = 0.0;
};

/// How it ended, for people: "it ended with status 3", or the signal in words.
std::string end_text(const ProcessEnd& end);

/// Where a child's standard output goes.
enum class ChildOutput { nowhere, ours };

/// A program run without a shell, fed through its standard input. Ended and waited for when the object goes
/// away; ended by the system when the thread that made the object ends, and so when the process is killed.
class ChildProcess {
 public:
  /// Starts the program. Throws RunFailure with the system's reason when it can't.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               ChildOutput output = ChildOutput::nowhere);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Feeds all bytes to the program's standard input. False when it no longer reads them. Throws Interrupted.
  bool feed(std::span<const std::byte> bytes, const StopTest& stop = {});
  /// Closes the program's standard input and waits for its end. Throws Interrupted.
  ProcessEnd finish(const StopTest& stop = {});

 private:
  void watch_over(int input, int complaints);
  void end_unread();

  pid_t process_ = -1;
  int input_ = -1;
  int complaints_ = -1;
  std::string last_lines_;
  std::thread reader_;  ///< empties the program's standard error, which would block it when full
  std::optional<AtAbruptEnd> is_ended_;
};

}  // namespace taut
