#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/stop.h"
#include "motion/work_ledger.h"
#include "motion/run_measures.h"
#include "methods/method.h"
#include "scene/scene.h"

namespace taut {

/// A scene in motion. It moves in whole steps of 1/steps_per_second; step k is at exactly k/steps_per_second.
/// What is asked of it in between never changes the run.
class Simulation {
 public:
  /// Refers to the scene from then on. Throws BadRequest when the scene's method can't do what the scene
  /// needs.
  explicit Simulation(const Scene& scene);

  /// The state at a time (s), which must not be earlier than the one asked for before: between two steps
  /// interpolated from the two. Nothing when told to stop on the way. Throws RunFailure, in words, when a
  /// step fails, and when the masses move with 10³ times the scene's energy; it then says with how many steps
  /// per second the method would hold, where that is found soon.
  std::optional<State> at(double time, const StopTest& stop = {});

  /// Steps made so far.
  std::int64_t steps() const { return steps_; }
  /// What the steps so far did, added up.
  const StepReport& report() const { return report_; }
  /// The state as reports show it (velocities projected where the method keeps half a kick in them).
  State reported(const State& state) const;
  /// What was measured of the run up to a state that at() gave.
  RunMeasures measures(const State& state) const;

 private:
  Simulation(const Scene& scene, const Method& method);
  double step_time(std::int64_t step) const { return static_cast<double>(step) / steps_per_second_; }
  void step();
  void look_at_energy() const;

  const Scene& scene_;
  const Method& method_;
  double steps_per_second_;
  std::unique_ptr<Stepper> stepper_;
  State state_;
  WorkLedger ledger_;
  double energy_scale_;          // J
  std::optional<State> before_;  ///< the step before state_, where a time in between was asked for
  std::int64_t steps_ = 0;
  StepReport report_;
};

}  // namespace taut
