#include "output/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "base/failure.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX wants it declared by who uses it

namespace taut {
namespace {

constexpr int milliseconds_between_looks = 10;

[[noreturn]] void cannot_start(const std::filesystem::path& program, int error) {
  throw RunFailure(
      fmt::format("can't start {}: {}", program.string(), std::generic_category().message(error)));
}

void close_if_open(int& descriptor) {
  if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

// What a spawned process starts with; freed with the object.
struct SpawnSetup {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;

  SpawnSetup() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
  }
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;

  void connect(int input, int complaints, ChildOutput output) {
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    if (output == ChildOutput::nowhere)
      posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, complaints, STDERR_FILENO);
  }

  // A process group of its own: Ctrl-C is for us, who then decide what becomes of the child.
  void detach_from_terminal() {
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
};

// Reads until the other end closes, and keeps the tail.
void keep_last(int descriptor, std::string& tail) {
  constexpr std::size_t kept = 2000;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    tail.append(buffer.data(), static_cast<std::size_t>(count));
    if (tail.size() > kept) tail.erase(0, tail.size() - kept);
  }
}

// Without taking note of it: wait_for() still has to.
bool has_ended(pid_t process) {
  siginfo_t end{};
  return ::waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         end.si_pid != 0;
}

// Its whole group: a grandchild would go on holding the pipe that is read here.
void kill_group(pid_t process) {
  ::kill(-process, SIGKILL);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

ProcessEnd wait_for(pid_t process) {
  int status = 0;
  rusage usage{};
  while (::wait4(process, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
          {},
          seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

}  // namespace

std::optional<std::filesystem::path> find_program(std::string_view name) {
  const char* variable = std::getenv("PATH");
  std::string_view folders = variable != nullptr ? variable : "/usr/bin:/bin";
  while (true) {
    const std::size_t end = folders.find(':');
    const std::filesystem::path candidate = std::filesystem::path(folders.substr(0, end)) / name;
    std::error_code error;
    if (std::filesystem::is_regular_file(candidate, error) && ::access(candidate.c_str(), X_OK) == 0)
      return candidate;
    if (end == std::string_view::npos) return std::nullopt;
    folders.remove_prefix(end + 1);
  }
}

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           ChildOutput output) {
  // A socket instead of a pipe as its input: sending to one whose reader has gone can be told not to raise
  // SIGPIPE.
  std::array<int, 2> input{-1, -1}, complaints{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input.data()) != 0) cannot_start(program, errno);
  if (::pipe2(complaints.data(), O_CLOEXEC) != 0) {
    const int error = errno;
    for (int& descriptor : input) close_if_open(descriptor);
    cannot_start(program, error);
  }
  input_ = input[0];
  complaints_ = complaints[0];

  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  SpawnSetup setup;
  setup.connect(input[1], complaints[1], output);
  setup.detach_from_terminal();
  const int error =
      ::posix_spawn(&process_, program.c_str(), &setup.files, &setup.attributes, pointers.data(), environ);
  close_if_open(input[1]);
  close_if_open(complaints[1]);
  if (error != 0) {
    close_if_open(input_);
    close_if_open(complaints_);
    cannot_start(program, error);
  }
  ::shutdown(input_, SHUT_RD);
  is_ended_.emplace([process = process_] {
    kill_group(process);
    siginfo_t end{};
    ::waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WNOWAIT);  // then it makes no more files
  });
  reader_ = std::thread(keep_last, complaints_, std::ref(last_lines_));
}

ChildProcess::~ChildProcess() {
  if (process_ < 0) return;
  kill_group(process_);
  finish();
}

bool ChildProcess::feed(std::span<const std::byte> bytes, const StopTest& stop) {
  while (!bytes.empty()) {
    stop_if_told(stop);
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      pollfd room{input_, POLLOUT, 0};
      ::poll(&room, 1, milliseconds_between_looks);
      continue;
    }
    if (sent < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

ProcessEnd ChildProcess::finish(const StopTest& stop) {
  close_if_open(input_);
  while (stop && !has_ended(process_)) {
    stop_if_told(stop);
    ::poll(nullptr, 0, milliseconds_between_looks);
  }
  reader_.join();
  close_if_open(complaints_);
  is_ended_.reset();
  ProcessEnd end = wait_for(std::exchange(process_, -1));
  end.last_lines = std::move(last_lines_);
  return end;
}

}  // namespace taut
