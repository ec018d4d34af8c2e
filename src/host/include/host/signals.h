#pragma once

#include <functional>
#include <thread>

namespace taut {

/// A file that may not grow further and a reader that has gone make writing fail, with a reason that can be
/// told, instead of ending the process without a word.
void ignore_write_signals();

/// While it lives, the first SIGINT, SIGTERM, SIGXCPU or SIGHUP (but under nohup) does not end the process
/// but is remembered, so that what is being made can be brought to a whole end; the second one ends it as
/// usual. At most one at a time.
class InterruptWatch {
 public:
  /// `end_at_once` is called with the signal, in a thread of its own, where the watch still lives 0.8 s after
  /// it: whatever is going on then does not ask often enough. (Under sanitizers, where all takes longer, 6
  /// s.)
  explicit InterruptWatch(std::function<void(int)> end_at_once);
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// The signal that came, 0 so far.
  int caught() const;

 private:
  std::thread deadline_;
};

}  // namespace taut
