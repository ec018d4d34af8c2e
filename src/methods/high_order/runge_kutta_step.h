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
  RungeKuttaStep(const Model& model, Workers* workers) : model_(model), workers_(workers) {}

  /// From a time, where the masses have these accelerations, on by h; looked() is called with the number of
  /// each stage behind the first, once it is evaluated. False where a stage can't be.
  template <class Look>
  bool make(Equations& equations, double time, double h, const Vectors& position, const Vectors& velocity,
            const Vectors& acceleration, const Look& look) {
    time_ = time;
    h_ = h;
    start_ = {&position, &velocity, &acceleration};
    for (std::size_t stage = 1; stage < dop853::stages; ++stage) {
      if (!evaluate(equations, stage)) return false;
      look(stage);
    }
    return true;
  }

  /// Where the masses are in a stage that has been evaluated.
  const Vectors& positions(std::size_t stage);

  /// Where the step ends, and the estimate of its error over what is allowed: `position` (m) in a position,
  /// `velocity` (m/s) in a velocity. Not finite where the step isn't.
  double end(double position, double velocity, Phase& end);

  /// Takes over what the step began with, for between(): what was given to make() is something else after it.
  void keep_start(Vectors& position, Vectors& velocity, Vectors& acceleration);

  /// To be called before between(), with the end as it was taken over and its accelerations: three more
  /// evaluations. False where they can't be made.
  bool prepare_interpolant(Equations& equations, const Vectors& position, const Vectors& velocity,
                           const Vectors& acceleration);

  /// Positions and velocities at a share of the step, to order 7.
  void between(double share, Phase& phase);

 private:
  // What a step begins with: what was given to make(), until it is kept.
  struct Start {
    const Vectors *position = nullptr, *velocity = nullptr, *acceleration = nullptr;
  };

  double time_of(std::size_t stage) const { return time_ + dop853::nodes[stage] * h_; }
  const Vectors& acceleration(std::size_t stage) const {
    return stage == 0 ? *start_.acceleration : accelerations_[stage];
  }
  void add(const dop853::StageWeights& weights, VectorSums& sums) const;
  const PhaseSums& sums_of(std::size_t stage);
  bool evaluate(Equations& equations, std::size_t stage);

  const Model& model_;
  Workers* workers_;  // null: the calling thread alone
  double time_ = 0.0, h_ = 0.0;
  Start start_;
  Phase kept_start_, end_;
  std::array<Vectors, dop853::all_stages> accelerations_;  // the first is the start's, once it is kept
  // Room for sums, and for what they are.
  PhaseSums sums_;
  Phase phase_;
};

}  // namespace taut
