#pragma once

#include <vector>

#include "model/limits.h"
#include "model/model.h"

namespace taut {

/// Relaxation of a model's limits on angles, for methods that move positions and derive velocities from them:
/// stops are plastic, what an angle loses at one is gone.
class LimitSolver {
 public:
  explicit LimitSolver(const Model& model);

  /// To be called at the start of a step.
  void begin_step();

  /// One pass over all limits, each with C = its overshoot, C ≤ 0, and gradients ∇ᵢC:
  ///   Δλ = (−C − α̃ λ)/(Σ wᵢ|∇ᵢC|² + α̃),  λ + Δλ ≤ 0,  xᵢ ← xᵢ + wᵢ Δλ ∇ᵢC,
  /// with α̃ = compliance/h² and wᵢ = answer/mᵢ (XPBD, 2016, eq. 18; `answer` as drag needs it).
  void solve(Vectors& position, double h, double answer) { solve_along(position, position, h, answer); }

  /// The same, but masses move along the gradients at the start of the step, and Σ wᵢ ∇ᵢC·∇ᵢC₀ takes the
  /// place of Σ wᵢ|∇ᵢC|²: what SHAKE does to links.
  void solve_along(const Vectors& start, Vectors& position, double h, double answer);

  /// Whether any of them has pushed in this step.
  bool pushed() const { return pushed_; }

  std::int64_t size() const { return static_cast<std::int64_t>(limits_.size()); }

 private:
  // How hard a stop has pushed in this step, and at which end of the range.
  struct Push {
    double multiplier = 0.0;
    double sign = 1.0;
  };

  const std::vector<Limit>& limits_;
  const std::vector<double>& inverse_mass_;
  std::vector<Push> pushes_;
  bool pushed_ = false;
};

}  // namespace taut
