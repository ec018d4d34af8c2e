#pragma once

#include <cstdint>
#include <string>

#include "methods/method.h"

namespace taut {

/// How a run has ended, where it has.
enum class RunEnd {
  none,         ///< it goes on
  step_failed,  ///< a step could not be solved, however often it was halved
  diverged,     ///< the masses move with more energy than there can be
};

/// What a run has done so far.
struct RunReport {
  RunEnd end = RunEnd::none;
  StepReport counts;               ///< sums over all steps; status and worst link are those of the last one
  std::int64_t steps = 0;          ///< of 1/steps_per_second, done
  std::int64_t halved_steps = 0;   ///< of those, how many were made in halves, or parts of them
  int deepest_halving = 0;         ///< how often in a row at most
  double first_halved_at = 0.0;    ///< s, the start of the first step that was halved
  double last_halved_at = 0.0;     ///< s, the start of the last one
  Index halved_at_link = no_link;  ///< where the last of them had failed

  /// Whether so many steps were halved that people should hear of it: more than a few, and more than one in a
  /// thousand.
  bool worth_telling() const { return halved_steps > 3 && 1000 * halved_steps > steps; }
};

/// What a run did beyond the ordinary, as a sentence; empty where that is nothing.
std::string halving_sentence(const Model& model, const RunReport& report);

}  // namespace taut
