#pragma once

namespace taut {

/// While it lives, the first SIGINT or SIGTERM does not end the process but is remembered, so that what is
/// being made can be brought to a whole end; the second one ends it as usual. At most one at a time.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// The signal that came, 0 so far.
  int caught() const;
};

}  // namespace taut
