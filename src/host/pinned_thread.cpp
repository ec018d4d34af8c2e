#include "host/pinned_thread.h"

namespace taut {

PinnedThread::PinnedThread() {
  const int processor = ::sched_getcpu();
  if (processor < 0 || ::sched_getaffinity(0, sizeof before_, &before_) != 0) return;
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(processor, &only);
  pinned_ = ::sched_setaffinity(0, sizeof only, &only) == 0;
}

PinnedThread::~PinnedThread() {
  if (pinned_) ::sched_setaffinity(0, sizeof before_, &before_);
}

}  // namespace taut
