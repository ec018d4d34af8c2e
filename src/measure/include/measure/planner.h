#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "measure/truth.h"
#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// How good a run has to be.
struct AccuracyTarget {
  ErrorKind kind = ErrorKind::trajectory;
  double error = 0.01;  ///< as Errors has it; in metres where `metres` is set
  bool metres = false;
};

/// Reads "1%", "0.01", "trajectory=1mm", "strain=1e-3", "sag=0.5%"; without a kind it is the trajectory.
/// Lengths in m, cm or mm are for trajectory and sag. Nothing where the text is no such thing.
std::optional<AccuracyTarget> parse_accuracy(std::string_view text);

/// The cheapest way that is good enough, as far as short runs tell.
struct Plan {
  Settings settings;                       ///< complete
  bool reached = false;                    ///< false: nothing tried was good enough, and this is the best
  ErrorKind kind = ErrorKind::trajectory;  ///< what it was judged by: the target's kind, or sag where no two
                                           ///< methods agree on a trajectory
  double wanted = 0.0;                     ///< error
  double estimated_error = 0.0;            ///< over the time that was looked at
  double looked_until = 0.0;               ///< s
  double predicted_seconds = 0.0;          ///< of the whole run, as predicted_seconds() has it
  std::size_t runs = 0;                    ///< short runs it took
  std::string why;                         ///< a sentence for people: what was chosen and why
};

/// Plans a run of `duration` seconds. Every method that can do the scene makes short runs with ever finer
/// steps and 1, 4 and 16 passes, until two different methods agree, and each of them with itself at half the
/// step, within a quarter of the target at all of eight instants, or the work that may be spent on it is; the
/// time on which two agree is what counts, and the surer of the two is the measure. Where none do, as chaos
/// has it, it is tried again over a quarter of the time, twice. Of all runs within seven tenths of the target
/// the one is taken that is predicted to be cheapest. `only`: a method that the plan has to use; empty: any.
/// Decided by counts alone, never by a clock: the same scene gets the same plan.
Plan make_plan(const Model& model, const State& start, double duration, const AccuracyTarget& target,
               std::string_view only = {});

}  // namespace taut
