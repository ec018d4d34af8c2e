#pragma once

namespace taut {

/// How the program ends.
enum ExitStatus : int {
  exit_done = 0,
  exit_failed = 1,       ///< while running
  exit_bad_request = 2,  ///< bad usage or a bad scene; nothing was written
  exit_incomplete = 3,   ///< some of what was asked for is missing
  exit_conflict = 4,     ///< output exists from other inputs
  exit_not_whole = 5,    ///< verification failed
  exit_signal = 128,     ///< plus the signal's number
};

}  // namespace taut
