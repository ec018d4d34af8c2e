#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/stop.h"
#include "frames/trail_recorder.h"
#include "motion/run.h"
#include "scene/scene.h"

namespace taut {

/// All that it takes to go on with a simulation: its run's state, and its trails as bytes.
struct SavedSimulation {
  RunState run;
  std::string trails;
};

/// The same as bytes.
std::string to_bytes(const SavedSimulation& saved);
/// Appends them to others, with their number before them, and without a second copy of them.
void append_saved(const SavedSimulation& saved, std::string& bytes);

/// A scene's run, for those who want it whole or an error in words.
class Simulation {
 public:
  /// Refers to the scene from then on. Throws BadRequest when the scene's method refuses it.
  explicit Simulation(const Scene& scene, const Execution& execution = {});
  /// Goes on from what save_before() gave, as bytes, for the same scene: every bit is as if it had never been
  /// left. Throws BadRequest where the bytes are of another scene.
  Simulation(const Scene& scene, std::string_view saved, const Execution& execution = {});

  /// The state at a time (s), which must not be earlier than the one asked for before: between two steps
  /// interpolated from the two. Nothing when told to stop on the way. Throws RunFailure, in words, when the
  /// run ends before; it then says with how many steps per second the method was found to hold, or why
  /// it fails (failure_advice.h).
  std::optional<State> at(double time, const StopTest& stop = {});

  /// All that it takes to go on at a time (s) later than the one asked for last, and after it; nothing where
  /// the last step went beyond that time, when told to stop, or where the run ends before.
  std::optional<SavedSimulation> save_before(double time, const StopTest& stop = {});

  /// The same of a run that has ended.
  SavedSimulation save_end() const;

  /// The trails that the scene's look shows, up to a state that at() gave last; null where it shows none.
  std::shared_ptr<const Trails> trails(const State& state) const { return trails_.up_to(state); }

  const Run& run() const { return run_; }
  std::int64_t steps() const { return run_.steps(); }
  State reported(const State& state) const { return run_.reported(state); }
  /// What was measured of the run up to a state that at() gave.
  RunMeasures measures(const State& state) const { return run_.measures(state); }

 private:
  std::optional<State> state_at(double time, const StopTest& stop);

  const Scene& scene_;
  Run run_;
  TrailRecorder trails_;
};

}  // namespace taut
