#pragma once

#include <memory>
#include <optional>

#include "frames/trail_recorder.h"
#include "motion/run.h"
#include "output/motion_file.h"
#include "scene/scene.h"

namespace taut {

/// Plays a motion that was simulated before, as if it were simulated now.
class MotionPlayer {
 public:
  /// Refers to the scene and the motion, which must be of the same physics, from then on.
  MotionPlayer(const Scene& scene, const MotionReader& motion);

  /// The state at a time (s) that is not before the one asked for last. Points of trails are interpolated
  /// between moments. Throws BadRequest where the motion has no such moment, RunFailure where it is damaged.
  State at(double time);
  /// The trails that the scene's look shows, up to a state that at() gave last; null where it shows none.
  std::shared_ptr<const Trails> trails(const State& state) const { return trails_.up_to(state); }
  /// What was measured of the run up to the state that at() gave last.
  RunMeasures measures() const;

 private:
  const Scene& scene_;
  const MotionReader& motion_;
  EnergyBase energy_base_;
  TrailRecorder trails_;
  RunState now_;
};

}  // namespace taut
