#include "host/patience.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "host/progress.h"
#include "host/standard_streams.h"

namespace taut {
namespace {

using PatienceClock = std::chrono::steady_clock;
using Pause = std::chrono::duration<double>;

constexpr Pause first_pause{2.0}, pause_after_others{10.0};
constexpr double growth = 2.0;

}  // namespace

Patience::Patience(std::FILE* stream, bool quiet, std::string what)
    : stream_(stream), what_(std::move(what)) {
  if (!quiet) thread_ = std::thread([this] { wait(); });
}

Patience::~Patience() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Patience::heard() {
  {
    const std::lock_guard lock(mutex_);
    heard_ = true;
  }
  changed_.notify_all();
}

void Patience::wait() {
  PatienceClock::time_point since = PatienceClock::now();
  Pause pause = first_pause;
  std::unique_lock lock(mutex_);
  while (!ended_) {
    const bool changed = changed_.wait_for(lock, pause, [this] { return ended_ || heard_; });
    if (ended_) return;
    if (changed) {
      heard_ = false;
      since = PatienceClock::now();
      pause = pause_after_others;
      continue;
    }
    show_text(stream_, fmt::format("taut: still {}; nothing new for {}\n", what_,
                                   duration_text(Pause(PatienceClock::now() - since).count())));
    pause *= growth;
  }
}

}  // namespace taut
