#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A target's error as Errors has it.
double wanted_error(const AccuracyTarget& target, const Model& model, const State& start);

/// Whether a time (s) is the end of a run, but for what truths leave out of it: they end on whole sixtieths
/// of a second.
bool reaches_the_end(double until, double duration);

/// How a scene is to be run, and what is known of how good that is.
struct Plan {
  Settings settings;                       ///< complete
  bool searched = false;                   ///< by make_plan(); else by quick_plan()
  bool reached = false;                    ///< false: nothing tried is known to be good enough
  ErrorKind kind = ErrorKind::trajectory;  ///< what it was judged by
  double wanted = 0.0;                     ///< error
  std::optional<double> estimated_error;   ///< over the time that was judged; nothing where none could be
  double judged_until = 0.0;               ///< s
  double duration = 0.0;                   ///< s, of the run that is planned
  double size = 0.0;                       ///< m, scene_size(): what errors of place are shares of
  double predicted_seconds = 0.0;          ///< of the whole run, as predicted_seconds() has it
  std::size_t runs = 0;                    ///< short runs it took
  std::string why;                         ///< a sentence for people: what was chosen and why
  std::vector<std::string> reasons;        ///< more of it, a line each

  /// How much of the run the estimate holds for, 0 to 1.
  double judged_share() const {
    return estimated_error && duration > 0.0 ? std::min(1.0, judged_until / duration) : 0.0;
  }
  bool judged_to_the_end() const { return estimated_error && reaches_the_end(judged_until, duration); }
};

/// Method, step and passes in a few words: "xpbd at 480 steps/s, 1 pass".
std::string settings_text(const Settings& settings);

/// What is known of how accurate the plan's run will be, as a sentence: how large an error is expected of how
/// much of the run, in shares of the size and in metres; or that it can't be judged.
std::string accuracy_sentence(const Plan& plan);

}  // namespace taut
