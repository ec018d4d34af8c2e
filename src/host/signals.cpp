#include "host/signals.h"

#include <semaphore.h>
#include <signal.h>
#include <time.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <utility>

namespace taut {
namespace {

// Also what comes when a terminal goes away, and when the time that the system gives is used up.
constexpr std::array watched{SIGHUP, SIGINT, SIGTERM, SIGXCPU};
#ifdef TAUT_SANITIZED
constexpr double seconds_to_end = 6.0;
#else
constexpr double seconds_to_end = 0.8;
#endif

// A handler gets no argument of ours, so these have to be found from anywhere.
std::atomic<int> caught_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait");
sem_t news;  // posted by a signal, and at the end of the watch

extern "C" void remember_signal(int signal) {
  const int error = errno;
  caught_signal.store(signal);
  ::sem_post(&news);
  errno = error;
}

void wait_for_news() {
  while (::sem_wait(&news) != 0 && errno == EINTR) {
  }
}

// False when there was none in that time.
bool wait_for_news(double seconds) {
  constexpr long second = 1'000'000'000;  // ns
  timespec until{};
  ::clock_gettime(CLOCK_REALTIME, &until);
  until.tv_nsec += static_cast<long>(seconds * static_cast<double>(second));
  until.tv_sec += until.tv_nsec / second;
  until.tv_nsec %= second;
  int result = 0;
  while ((result = ::sem_timedwait(&news, &until)) != 0 && errno == EINTR) {
  }
  return result == 0;
}

// Whoever starts a program by nohup wants it to go on without its terminal. (An ignored SIGINT says nothing
// of the kind: shells ignore it for whatever a script starts in the background.)
bool is_to_outlive(int signal) {
  struct sigaction now {};
  return signal == SIGHUP && ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void ignore_write_signals() {
  struct sigaction action {};
  action.sa_handler = SIG_IGN;
  for (const int signal : {SIGXFSZ, SIGPIPE}) ::sigaction(signal, &action, nullptr);
}

InterruptWatch::InterruptWatch(std::function<void(int)> end_at_once) {
  caught_signal.store(0);
  ::sem_init(&news, 0, 0);
  deadline_ = std::thread([end = std::move(end_at_once)] {
    wait_for_news();
    if (caught_signal.load() != 0 && !wait_for_news(seconds_to_end)) end(caught_signal.load());
  });
  struct sigaction action {};
  action.sa_handler = remember_signal;
  // One shot: the second signal finds the default action. Restart: library calls need not know of this.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : watched)
    if (!is_to_outlive(signal)) ::sigaction(signal, &action, nullptr);
}

InterruptWatch::~InterruptWatch() {
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  for (const int signal : watched)
    if (!is_to_outlive(signal)) ::sigaction(signal, &action, nullptr);
  ::sem_post(&news);
  deadline_.join();
  ::sem_destroy(&news);
}

int InterruptWatch::caught() const {
  return caught_signal.load();
}

}  // namespace taut
