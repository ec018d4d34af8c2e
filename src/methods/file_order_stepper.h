#pragma once

#include <utility>

#include "methods/method.h"

namespace taut {

/// A stepper that keeps what moves as a State, in the order of the file.
class FileOrderStepper : public Stepper {
 public:
  void load(const State& state) final;
  StepReport step(double h, double end_time) final;
  const State& store() final { return state_; }
  std::optional<double> energy() final { return energy_; }
  void undo() override {}

 protected:
  State state_;
  std::optional<double> energy_;  // as energy() is to give it; only known where the last step has set it
  bool goes_on_ = false;          // whether the state is as the last step of make_step() has left it

 private:
  /// Moves the state on, or leaves it as it was where that fails.
  virtual StepReport make_step(State& state, double h, double end_time) = 0;
  /// Called before the first step, and before the next one whenever other links are whole than before: what
  /// is only looked at, and makes no step, has no system worked out for it.
  virtual void links_changed(const State& state) = 0;

  bool links_changed_ = true;
};

/// One that works a step out beside the state, and then changes the two about: so it can take a step back.
class SwappingStepper : public FileOrderStepper {
 public:
  void undo() final;

 protected:
  /// Begins a step: the work is a copy of the state …
  void copy_to_work(const State& state);
  /// … or as large as that, with a copy of its tensions, unless the step sets all of them.
  void begin_work(const State& state, bool sets_tensions = false);
  /// Ends one: swaps the work in and moves the time on, or reports not_finite and changes nothing. Where the
  /// energy is known and finite, so is all that it was summed from, which is all there is.
  void take_over(State& state, double end_time, StepReport& report);

  Vectors position_, velocity_;
  std::vector<double> tension_;

 private:
  double time_before_ = 0.0, kick_before_ = 0.0;
  std::vector<double> tension_before_;
  std::vector<Vec3> joints_before_;
};

}  // namespace taut
