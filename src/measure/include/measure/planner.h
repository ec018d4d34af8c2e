#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/stop.h"
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
  ErrorKind kind = ErrorKind::trajectory;  ///< what it was judged by: judging_kind()
  double wanted = 0.0;                     ///< error
  double estimated_error = 0.0;            ///< over the time that was looked at
  double looked_until = 0.0;               ///< s
  double predicted_seconds = 0.0;          ///< of the whole run, as predicted_seconds() has it
  std::size_t runs = 0;                    ///< short runs it took
  std::string why;                         ///< a sentence for people: what was chosen and why
};

/// A target's error as Errors has it.
double wanted_error(const AccuracyTarget& target, const Model& model, const State& start);

/// The kind of error by which a truth judges a target: the target's, or the sag where that alone can be told
/// finely enough.
ErrorKind judging_kind(const Truth& truth, ErrorKind kind, double wanted);

/// Plans a run of `duration` seconds: walks the grid of methods, steps and passes from cheap to dear
/// (GridWalk), judges every run by the truth up to its horizon, and takes the one predicted to be cheapest of
/// those within nine tenths of the target; dearer ones are not run. Where none is good enough before the work
/// that may be spent on it is, the best is taken. `only`: a method that the plan has to use; empty: any.
/// Decided by counts alone, never by a clock: the same scene gets the same plan. Throws Interrupted.
Plan make_plan(const Model& model, const State& start, const Truth& truth, double duration,
               const AccuracyTarget& target, std::string_view only = {}, const StopTest& stop = {});

}  // namespace taut
