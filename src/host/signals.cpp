#include "host/signals.h"

#include <signal.h>

#include <array>
#include <atomic>

namespace taut {
namespace {

constexpr std::array watched{SIGINT, SIGTERM};

// A handler gets no argument of ours, so this has to be found from anywhere.
std::atomic<int> caught_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait");

extern "C" void remember_signal(int signal) {
  caught_signal.store(signal);
}

}  // namespace

InterruptWatch::InterruptWatch() {
  caught_signal.store(0);
  struct sigaction action {};
  action.sa_handler = remember_signal;
  // One shot: the second signal finds the default action. Restart: library calls need not know of this.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : watched) ::sigaction(signal, &action, nullptr);
}

InterruptWatch::~InterruptWatch() {
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  for (const int signal : watched) ::sigaction(signal, &action, nullptr);
}

int InterruptWatch::caught() const {
  return caught_signal.load();
}

}  // namespace taut
