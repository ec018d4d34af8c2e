#pragma once

#include <stdexcept>
#include <string>

namespace taut {

/// The user asked for something that can't be done as asked: a bad flag, a bad scene. Exit status 2, nothing
/// written.
class BadRequest : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Something went wrong while running: a full disk, a missing program, a step that can't be solved. Exit
/// status 1; what was written before stays.
class RunFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Output exists that was made from other inputs. Exit status 4, nothing written.
class OutputConflict : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace taut
