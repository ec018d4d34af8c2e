#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/stop.h"
#include "model/description.h"

namespace taut {

/// A square sheet with diagonals, hung level by two corners: what relaxation is timed on.
Description square_sheet(int size);

/// How fast one way of running a model is on this machine.
struct Speed {
  std::string model;   ///< such as "sheet of 64 × 64"
  std::string method;  ///< such as "xpbd single"
  int threads = 1;
  std::size_t masses = 0, links = 0;
  double step = 0.0;      ///< s, the median step of one pass
  double per_link = 0.0;  ///< s, the same over the links
};

/// Times chains and sheets with diagonals by the methods they are usual for, on one thread and, where the
/// machine has more, on `threads`, for about so many seconds each. `done` hears of every one. Throws
/// Interrupted.
std::vector<Speed> measure_speed(double seconds_each, int threads,
                                 const std::function<void(std::size_t done, std::size_t of)>& done,
                                 const StopTest& stop);

}  // namespace taut
