#pragma once

#include <Eigen/Core>
#include <vector>

#include "direct/link_system.h"
#include "model/limits.h"

namespace taut {

/// How far an angle may be beyond its range where a direct solve ends (rad).
inline constexpr double limit_tolerance = 1e-10;

/// The limits on angles that push in a step, beside a link system that is solved directly: an active set.
/// Each is a row G and a column G₀ of gradients, and borders the links' matrix A = R W Cᵀ,
///   ( A        R W G₀ᵀ ) (λ)   (r)
///   ( G W Cᵀ   D       ) (μ) = (c),    D = G W G₀ᵀ + α̃,
/// which is solved by way of the small matrix D − (G W Cᵀ) A⁻¹ (R W G₀ᵀ). Where limits or links say the same
/// twice, the least μ is taken.
class ActiveLimits {
 public:
  explicit ActiveLimits(const Model& model);

  bool none() const { return limits_.empty(); }

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

 private:
  // A limit that takes part in a solve.
  struct Row {
    std::size_t limit;
    LimitAngle along, column;  // ∇C now, and the direction its masses are moved in
    double wanted;             // c
    double compliance;         // α̃
  };
  // How hard a stop has pushed in this step, and at which end of the range.
  struct Push {
    double multiplier = 0.0;
    double sign = 1.0;
  };

  LimitAngle outward(std::size_t limit, double sign, const Vectors& position) const;
  double own_weight(std::size_t limit, const LimitAngle& along) const;
  double product(const Row& row, const Row& column) const;
  double change(const Row& row, const Vectors& velocity) const;
  void move(std::size_t limit, const LimitAngle& column, double strength, Vectors& target) const;
  void reach(const Row& column, Vectors& moved) const;
  double felt(const Row& row, const SystemLinks& links, const Vectors& columns,
              const std::vector<double>& strength) const;
  Eigen::VectorXd solve(const LinkSystem& system, const Vectors& rows, const Vectors& columns,
                        std::vector<double>& links);

  const std::vector<Limit>& limits_;
  const std::vector<double>& inverse_mass_;
  std::vector<Push> pushes_;
  std::vector<Push> start_pushes_;  // of soft limits at the start of a step with half kicks
  std::vector<double> share_;       // of h² τ₁ that μ is
  std::vector<Row> active_;
  // Room for a solve.
  std::vector<std::vector<double>> answers_;  // A⁻¹ R W G₀ᵀ
  Vectors moved_;
  std::vector<double> given_;
  double h_ = 0.0;  // s
};

}  // namespace taut
