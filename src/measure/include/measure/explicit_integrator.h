#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/stop.h"
#include "methods/acceleration.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Dormand and Prince's explicit Runge–Kutta pair of order 5(4) on the equations at acceleration level
/// (methods/acceleration.h), with step control: the local error of every position stays below `tolerance` (m)
/// and that of every velocity below ten times that per second. A second opinion of another kind than any
/// method in the registry: nothing is projected, and link lengths drift by the integration error alone.
/// (Dormand and Prince, A family of embedded Runge–Kutta formulae, 1980.)
class ExplicitIntegrator {
 public:
  /// Refers to the model from then on.
  ExplicitIntegrator(const Model& model, const State& start, double tolerance);

  /// Moves on to a time (s). False, and of no more use, where the equations are singular on the way, or take
  /// more than so many evaluations since the start.
  bool advance_to(double time, long most_evaluations, const StopTest& stop = {});

  /// The state at the time moved to.
  State state() const;

  /// Evaluations of the equations since the start.
  long evaluations() const { return evaluations_; }

 private:
  static constexpr std::size_t stages = 7;

  // Position and velocity, and at the same time their derivatives.
  struct Phase {
    Vectors position, velocity;
  };

  double attempt(double h);

  const Model& model_;
  State start_;
  AccelerationField field_;
  double tolerance_;
  double time_, h_ = 1e-4;
  long evaluations_ = 0;
  Phase now_, next_;
  std::array<Phase, stages> slopes_;
};

/// The states at the given rising times; only those that were reached.
std::vector<State> integrate_explicitly(const Model& model, const State& start,
                                        const std::vector<double>& times, double tolerance,
                                        long most_evaluations = 2'000'000);

}  // namespace taut
