#pragma once

#include <sched.h>

namespace taut {

/// While it lives, this thread stays on the processor it runs on, so that what is timed is not moved about.
/// Does nothing where the system does not allow it.
class PinnedThread {
 public:
  PinnedThread();
  ~PinnedThread();
  PinnedThread(const PinnedThread&) = delete;
  PinnedThread& operator=(const PinnedThread&) = delete;

 private:
  cpu_set_t before_;
  bool pinned_ = false;
};

}  // namespace taut
