#pragma once

#include <array>
#include <utility>

#include "base/vectors.h"
#include "high_order/equations.h"
#include "high_order/tableau.h"

namespace taut {

/// Positions and velocities of all masses; or their derivatives.
struct Phase {
  Vectors position, velocity;
};

/// One step of DOP853 of the equations of motion, and what lies between its ends. Driven pins are, in every
/// stage, where they belong at its time.
class RungeKuttaStep {
 public:
  explicit RungeKuttaStep(const Model& model) : model_(model) {}

  /// From a time, where the masses have these accelerations, on by h; looked() is called with the number of
  /// each stage behind the first, and its positions, once it is evaluated. False where a stage can't be.
  template <class Look>
  bool make(Equations& equations, double time, double h, const Vectors& position, const Vectors& velocity,
            const Vectors& acceleration, const Look& look) {
    begin(time, h, position, velocity, acceleration);
    for (std::size_t stage = 1; stage < dop853::stages; ++stage) {
      if (!evaluate(equations, stage)) return false;
      look(stage, std::as_const(position_));
    }
    return true;
  }

  /// Where the step ends.
  void end(Phase& end) const;

  /// The estimate of its error over what is allowed: `position` (m) in a position, `velocity` (m/s) in a
  /// velocity. Not finite where the step isn't.
  double error(double position, double velocity) const;

  /// To be called before between(), with the end as it was taken over and its accelerations: three more
  /// evaluations. False where they can't be made.
  bool prepare_interpolant(Equations& equations, const Phase& end, const Vectors& acceleration);

  /// Positions and velocities at a share of the step, to order 7.
  void between(double share, Phase& phase) const;

 private:
  void begin(double time, double h, const Vectors& position, const Vectors& velocity,
             const Vectors& acceleration);
  bool evaluate(Equations& equations, std::size_t stage);

  const Model& model_;
  double time_ = 0.0, h_ = 0.0;
  Phase start_;
  std::array<Phase, dop853::all_stages> slopes_;
  Vectors position_;                   // of the present stage
  std::array<Phase, 7> coefficients_;  // of the interpolant, but for the first
};

}  // namespace taut
