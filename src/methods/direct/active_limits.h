#pragma once

#include <vector>

#include "direct/limit_border.h"
#include "model/state.h"

namespace taut {

/// How far an angle may be beyond its range where a direct solve ends (rad).
inline constexpr double limit_tolerance = 1e-10;

/// The limits on angles that push in a step, beside a link system that is solved directly: an active set.
/// They border the links' matrix (LimitBorder).
class ActiveLimits {
 public:
  explicit ActiveLimits(const Model& model);

  bool none() const { return limits_.empty(); }

  /// To be called before the first step and whenever links have broken: a limit on the reach of a broken one
  /// holds nothing.
  void links_changed(const State& state);

  /// To be called at the start of a step of h seconds, where soft limits are to push as hard as they must at
  /// its end: α̃ = α/h².
  void begin_step(double h);

  /// The same where they are to push with ς τ₀ + (1 − ς) τ₁ in each of the two half kicks of a step of second
  /// order, τ₀ and τ₁ being their torques at its start and end: moves the positions, which are about to be
  /// solved, by (h²/2) ς τ₀ along the gradients at `start`; what is left to solve for, μ = (h²/2)(1 − ς) τ₁,
  /// has α̃ = 2α/((1 − ς) h²). ς = 1/(2 (1 + ω²h²)²), with ω the limit's frequency between its masses: the
  /// trapezoidal rule, which damps nothing, where the step is short beside the limit's vibration, and where
  /// it is long the implicit one, which throws nothing back harder than it came.
  void begin_half_kicks(double h, const Vectors& start, Vectors& position);

  /// The second of those half kicks, at the end of the step: v ← v − answer (h/2)(ς τ₀ + (1 − ς) τ₁) W G₁ᵀ.
  void kick(const Vectors& position, double answer, Vectors& velocity) const;

  /// Finds those that are beyond their range at these positions, or have pushed in this step already, with
  /// gradients there as rows, and as columns those at `start` where that is given. Returns the largest
  /// |C − α̃ μ| among them (rad).
  double look(const Vectors& position, const Vectors* start = nullptr);

  /// Solves for the links' λ, in place of r, and the limits' μ, whose part of x ← x − answer W (Cᵀ λ + G₀ᵀ μ)
  /// it makes. A has been factorised; r holds 1/answer already, as drag needs it. A multiplier never pulls.
  void push(const LinkSystem& system, const Vectors& rows, const Vectors& columns, double answer,
            std::vector<double>& links, Vectors& position);

  /// Takes from velocities what goes into the hard stops that have pushed in this step, together with the
  /// links: λ takes the place of J v in `links`, and v ← v − W Gᵀ μ is made. A stop that would pull is left.
  /// Soft ones are springs, and leave velocities to kick().
  void stop(const LinkSystem& system, const Vectors& directions, const Vectors& position,
            std::vector<double>& links, Vectors& velocity);

  /// The tensions of one-sided links (N) at these positions, with `scale` what is to be made of the
  /// multipliers of the rigid ones.
  void give_tensions(double scale, const Vectors& position, std::vector<double>& tension) const;

 private:
  // How hard a stop has pushed in this step, and at which end of the range.
  struct Push {
    double multiplier = 0.0;
    double sign = 1.0;
  };

  const std::vector<Limit>& limits_;
  LimitBorder border_;
  std::vector<bool> let_go_;  // one a limit
  std::vector<Push> pushes_;
  std::vector<Push> start_pushes_;  // of soft limits at the start of a step with half kicks
  std::vector<double> share_;       // of h² τ₁ that μ is
  std::vector<LimitRow> active_;
  std::vector<double> given_;  // room for a solve
  double h_ = 0.0;             // s
};

}  // namespace taut
