#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/truth.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What a method makes of a scene: its two finest runs, looked at at the same times.
struct Opinion {
  std::string name;  ///< of the curve (curves.h)
  std::size_t method = 0;
  bool relaxes = false;
  double rate = 0.0;                ///< steps per second of the finer run
  std::vector<State> coarse, fine;  ///< the coarser has half the steps
};

/// The opinions of every method that can do the scene. Each runs with ever finer steps, as far as
/// `most_seconds` of one run go (as predicted_seconds() has it).
std::vector<Opinion> opinions_of(const Model& model, const State& start, const std::vector<double>& times,
                                 double most_seconds);

/// Whether all opinions are of one method.
bool one_method_alone(const std::vector<Opinion>& opinions);

/// The motion on which two methods agree longest, with themselves at half the step and with each other,
/// within a thousandth of the scene's size, or, where that reaches twice as far, within a hundredth; nothing
/// where none do at the first time. Where one method alone can do the scene, it is its own second opinion,
/// with half the step, and `how` says so. The motion ends before a link breaks. Errors are judged down to ten
/// times what the two differ by; a kind whose limit would lie above 10 % is not judged.
std::optional<Truth> agreed_motion(const Model& model, const State& start,
                                   const std::vector<Opinion>& opinions);

/// The same for scenes whose motion no two agree on: sag, energy and largest strain, at the times of the
/// opinions. `smallest` is empty where there are no two opinions, and the remark says so; it begins with
/// `why` there is no motion.
Truth agreed_summaries(const Model& model, const State& start, const std::vector<Opinion>& opinions,
                       const std::vector<double>& times, const std::string& why);

}  // namespace taut
