#pragma once

#include <functional>
#include <stdexcept>

namespace taut {

/// Asked now and then by whatever takes long; true means: come to a whole end soon.
using StopTest = std::function<bool()>;

/// What was told to stop had nothing whole to show yet. Exit status 128 and the signal's number.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Throws Interrupted when told to stop.
inline void stop_if_told(const StopTest& stop) {
  if (stop && stop()) throw Interrupted();
}

/// A test for what knows no Interrupted: never true, but throws it when told to stop. Refers to the other
/// test.
inline StopTest throwing(const StopTest& stop) {
  return [&stop] {
    stop_if_told(stop);
    return false;
  };
}

}  // namespace taut
