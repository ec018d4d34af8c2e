#pragma once

#include <vector>

#include "model/limits.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Relaxation of a model's limits on angles and on the reach of one-sided links, for methods that move
/// positions and derive velocities from them: stops are plastic, what an angle loses at one is gone.
class LimitSolver {
 public:
  explicit LimitSolver(const Model& model);

  /// To be called before the first step and whenever links have broken: a limit on the reach of a broken one
  /// holds nothing.
  void links_changed(const State& state);

  /// To be called at the start of a step.
  void begin_step();

  /// One pass over all limits, each with C = its overshoot, C ≤ 0, and gradients ∇ᵢC:
  ///   Δλ = (−C − α̃ λ)/(Σ wᵢ|∇ᵢC|² + α̃),  λ + Δλ ≤ 0,  xᵢ ← xᵢ + wᵢ Δλ ∇ᵢC,
  /// with α̃ = compliance/h² and wᵢ = answer/mᵢ (XPBD, 2016, eq. 18; `answer` as drag needs it).
  void solve(Vectors& position, double h, double answer) { solve_along(position, position, h, answer); }

  /// The same, but masses move along the gradients at the start of the step, and Σ wᵢ ∇ᵢC·∇ᵢC₀ takes the
  /// place of Σ wᵢ|∇ᵢC|²: what SHAKE does to links.
  void solve_along(const Vectors& start, Vectors& position, double h, double answer);

  /// Whether any limit on an angle has pushed in this step.
  bool pushed() const { return pushed_; }

  /// What one-sided links have pulled with in this step (N), with `scale` what is to be made of their
  /// multipliers, as −1/h².
  void give_tensions(double scale, std::vector<double>& tension) const;

  /// Takes from tensions that were continued in time what one-sided links can't have: a rope doesn't push.
  void keep_to_their_side(std::vector<double>& tension) const;

  std::int64_t size() const { return static_cast<std::int64_t>(order_.size()); }

 private:
  // How hard a stop has pushed in this step, and at which end of the range.
  struct Push {
    double multiplier = 0.0;
    double sign = 1.0;
  };

  void solve_one(std::size_t i, const Vectors& start, Vectors& position, double h, double answer);

  const Model& model_;
  const std::vector<Limit>& limits_;
  const std::vector<double>& inverse_mass_;
  std::vector<std::size_t> order_;  // of those that hold something
  std::vector<Push> pushes_;
  bool pushed_ = false;
};

}  // namespace taut
