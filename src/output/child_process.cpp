#include "output/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
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

// A pipe, or a pair of sockets; what was not taken out is closed with the object.
struct Ends {
  int ours = -1, childs = -1;

  Ends() = default;
  ~Ends() {
    close_if_open(ours);
    close_if_open(childs);
  }
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;

  // A socket instead of a pipe as the child's input: sending to one whose reader has gone can be told not to
  // raise SIGPIPE, nor to wait. 0, or the error.
  int make_sockets() {
    std::array<int, 2> both{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, both.data()) != 0) return errno;
    ours = both[0];
    childs = both[1];
    return 0;
  }
  // What the child writes into. 0, or the error.
  int make_pipe() {
    std::array<int, 2> both{-1, -1};
    if (::pipe2(both.data(), O_CLOEXEC) != 0) return errno;
    ours = both[0];
    childs = both[1];
    return 0;
  }
};

// While it lives no signal is handled in this thread.
class SignalsHeldBack {
 public:
  SignalsHeldBack() {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsHeldBack() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeldBack(const SignalsHeldBack&) = delete;
  SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;

 private:
  sigset_t before_{};
};

// All that a child needs between fork and exec, made before: there it may call nothing that takes memory or a
// lock.
struct Launch {
  const char* program;
  char* const* words;
  int input, complaints, news;  // news: where it says why it could not start
  ChildOutput output;
  pid_t parent;
};

// Signals as a program expects them; but where a file may grow no further it is to be told, and not to be
// ended without a word, as we are.
void give_back_signals() {
  struct sigaction action {};
  for (int signal = 1; signal < NSIG; ++signal) {
    action.sa_handler = signal == SIGXFSZ ? SIG_IGN : SIG_DFL;
    ::sigaction(signal, &action, nullptr);
  }
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

bool connect(const Launch& launch) {
  if (::dup2(launch.input, STDIN_FILENO) < 0 || ::dup2(launch.complaints, STDERR_FILENO) < 0) return false;
  if (launch.output == ChildOutput::ours) return true;
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  return nowhere >= 0 && ::dup2(nowhere, STDOUT_FILENO) >= 0;
}

[[noreturn]] void become_child(const Launch& launch) {
  // However we end, it ends, too; unless we ended already.
  const bool tied = ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && ::getppid() == launch.parent;
  // A process group of its own: Ctrl-C is for us, who then decide what becomes of the child.
  if (tied && ::setpgid(0, 0) == 0 && connect(launch)) {
    give_back_signals();
    ::execve(launch.program, launch.words, environ);
  }
  const int error = errno;
  const ssize_t ignored = ::write(launch.news, &error, sizeof error);
  static_cast<void>(ignored);
  ::_exit(127);
}

// What the child says that could not start; 0 once it is another program.
int start_error(int news) {
  int error = 0;
  ssize_t count = 0;
  while ((count = ::read(news, &error, sizeof error)) < 0 && errno == EINTR) {
  }
  return count == sizeof error ? error : 0;
}

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

// Its whole group, of which it is the first.
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
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return {signal != 0 ? 128 + signal : WEXITSTATUS(status),
          signal,
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

std::string end_text(const ProcessEnd& end) {
  if (end.signal == 0) return fmt::format("it ended with status {}", end.status);
  const char* const words = ::sigdescr_np(end.signal);
  return words != nullptr ? fmt::format("it was ended by the signal \"{}\"", words)
                          : fmt::format("it was ended by signal {}", end.signal);
}

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           ChildOutput output) {
  Ends input, complaints, news;
  for (const int error : {input.make_sockets(), complaints.make_pipe(), news.make_pipe()})
    if (error != 0) cannot_start(program, error);
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const Launch launch{program.c_str(), pointers.data(), input.childs, complaints.childs,
                      news.childs,     output,          ::getpid()};
  int fork_error = 0;
  {
    const SignalsHeldBack held_back;
    process_ = ::fork();
    if (process_ == 0) become_child(launch);
    if (process_ < 0) fork_error = errno;
  }
  if (fork_error != 0) cannot_start(program, fork_error);
  close_if_open(news.childs);
  if (const int error = start_error(news.ours); error != 0) {
    wait_for(std::exchange(process_, -1));
    cannot_start(program, error);
  }
  watch_over(std::exchange(input.ours, -1), std::exchange(complaints.ours, -1));
}

void ChildProcess::watch_over(int input, int complaints) {
  input_ = input;
  complaints_ = complaints;
  ::shutdown(input_, SHUT_RD);
  is_ended_.emplace([process = process_] {
    kill_group(process);
    siginfo_t end{};
    ::waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WNOWAIT);  // then it makes no more files
  });
  try {
    reader_ = std::thread(keep_last, complaints_, std::ref(last_lines_));
  } catch (const std::system_error& problem) {
    end_unread();
    throw RunFailure(fmt::format("no thread can be started to read what a program says: {}", problem.what()));
  }
}

void ChildProcess::end_unread() {
  kill_group(process_);
  is_ended_.reset();
  wait_for(std::exchange(process_, -1));
  close_if_open(input_);
  close_if_open(complaints_);
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
  while (!has_ended(process_)) {
    stop_if_told(stop);
    ::poll(nullptr, 0, milliseconds_between_looks);
  }
  kill_group(process_);  // what it left behind would hold the pipe that is read here
  reader_.join();
  close_if_open(complaints_);
  is_ended_.reset();
  ProcessEnd end = wait_for(std::exchange(process_, -1));
  end.last_lines = std::move(last_lines_);
  return end;
}

}  // namespace taut
