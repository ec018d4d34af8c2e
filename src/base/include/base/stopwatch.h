#pragma once

#include <chrono>

namespace taut {

/// Runs from its making on.
class Stopwatch {
 public:
  /// Seconds by the clock so far.
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace taut
