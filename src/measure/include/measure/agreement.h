#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/stop.h"
#include "measure/truth.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What a method makes of a scene: its two finest runs, looked at at the same times. Where something can hit
/// something, relaxing methods make 64 passes a step in the finer one and 16 in the coarser: few passes leave
/// impacts unfinished, and no shortening of steps makes that good.
struct Opinion {
  std::string name;  ///< of the curve (curves.h)
  std::size_t method = 0;
  bool relaxes = false;
  double rate = 0.0;                ///< steps per second of the finer run, as pace.h has it
  std::string pace;                 ///< the same for people
  std::vector<State> coarse, fine;  ///< the coarser has half the steps
};

/// The opinions of every method that can do the scene. Each runs with ever finer steps, as far as
/// `most_seconds` of one run go (as predicted_seconds() has it), or until half the step changes less than
/// `enough` of the scene's size. Where no link is rigid shake speaks for rattle, which is then the same.
/// Throws Interrupted.
std::vector<Opinion> opinions_of(const Model& model, const State& start, const std::vector<double>& times,
                                 double most_seconds, double enough = 1e-6, const StopTest& stop = {});

/// The motion on which two methods agree longest, with themselves at half the step and with each other,
/// within `bound` of the scene's size; nothing where none do at the first time. Where one method alone can do
/// the scene, it is its own second opinion, with half the step, and `how` says so. The motion ends before a
/// link breaks. Errors are judged down to ten times what the two differ by; a kind whose limit would lie
/// above 10 % is not judged.
std::optional<Truth> agreed_motion(const Model& model, const State& start,
                                   const std::vector<Opinion>& opinions, double bound);

/// The same for scenes whose motion no two agree on: sag, energy and largest strain, at the times of the
/// opinions. `smallest` is empty where there are no two opinions, and the remark says so; it begins with
/// `why` there is no motion.
Truth agreed_summaries(const Model& model, const State& start, const std::vector<Opinion>& opinions,
                       const std::vector<double>& times, const std::string& why);

}  // namespace taut
