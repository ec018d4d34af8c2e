#pragma once

#include <array>
#include <utility>

#include "high_order/equations.h"
#include "high_order/phase_sums.h"
#include "high_order/second_order.h"

namespace taut {

/// One step of DOP853 of the equations of motion, and what lies between its ends. Driven pins are, in every
/// stage, where they belong at its time.
class RungeKuttaStep {
 public:
  explicit RungeKuttaStep(const Model& model) : model_(model) {}

  /// From a time, where the masses have these accelerations, on by h; looked() is called with the number of
  /// each stage behind the first, once it is evaluated. False where a stage can't be.
  template <class Look>
  bool make(Equations& equations, double time, double h, const Vectors& position, const Vectors& velocity,
            const Vectors& acceleration, const Look& look) {
    begin(time, h, position, velocity, acceleration);
    for (std::size_t stage = 1; stage < dop853::stages; ++stage) {
      if (!evaluate(equations, stage)) return false;
      look(stage);
    }
    return true;
  }

  /// Where the masses are in a stage that has been evaluated.
  const Vectors& positions(std::size_t stage);

  /// Where the step ends.
  void end(Phase& end);

  /// The estimate of its error over what is allowed: `position` (m) in a position, `velocity` (m/s) in a
  /// velocity. Not finite where the step isn't.
  double error(double position, double velocity);

  /// To be called before between(), with the end as it was taken over and its accelerations: three more
  /// evaluations. False where they can't be made.
  bool prepare_interpolant(Equations& equations, const Phase& end, const Vectors& acceleration);

  /// Positions and velocities at a share of the step, to order 7.
  void between(double share, Phase& phase);

 private:
  void begin(double time, double h, const Vectors& position, const Vectors& velocity,
             const Vectors& acceleration);
  double time_of(std::size_t stage) const { return time_ + dop853::nodes[stage] * h_; }
  void add(const dop853::StageWeights& weights);
  const PhaseSums& sums_of(std::size_t stage);
  bool evaluate(Equations& equations, std::size_t stage);

  const Model& model_;
  double time_ = 0.0, h_ = 0.0;
  Phase start_, end_;
  std::array<Vectors, dop853::all_stages> accelerations_;
  // Room for sums, and for what they are.
  PhaseSums sums_;
  Phase phase_;
};

}  // namespace taut
