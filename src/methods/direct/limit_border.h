#pragma once

#include <Eigen/Core>
#include <vector>

#include "direct/link_system.h"
#include "model/limits.h"

namespace taut {

/// So many limits take a second a solve.
inline constexpr std::size_t most_limits_solved_together = 1000;

/// A limit on an angle, or on the reach of a one-sided link, that takes part in a solve.
struct LimitRow {
  std::size_t limit;
  LimitAngle along, column;  ///< ∇C where its rows are taken, and the direction its masses are moved in
  double wanted;             ///< the right side c
  double compliance;         ///< α̃
};

/// Limits on angles beside a link system that is solved directly. Each is a row G and a column G₀ of
/// gradients, and borders the links' matrix A = R W Cᵀ,
///   ( A        R W G₀ᵀ ) (λ)   (r)
///   ( G W Cᵀ   D       ) (μ) = (c),    D = G W G₀ᵀ + α̃,
/// which is solved by way of the small matrix D − (G W Cᵀ) A⁻¹ (R W G₀ᵀ). Where limits or links say the same
/// twice, the least μ is taken.
class LimitBorder {
 public:
  explicit LimitBorder(const Model& model);

  /// The gradient of the overshoot at one end of the range, +1 the upper or −1 the lower.
  LimitAngle outward(std::size_t limit, double sign, const Vectors& position) const;
  /// Σ w|∇C|²: what a unit push at the limit's masses, alone, makes of its angle.
  double own_weight(std::size_t limit, const LimitAngle& along) const;
  /// G u.
  double change(const LimitRow& row, const Vectors& u) const;
  /// target += strength W G₀ᵀ.
  void move(std::size_t limit, const LimitAngle& column, double strength, Vectors& target) const;

  /// λ in place of r in `links`, and returns μ. A has been factorised.
  Eigen::VectorXd solve(const LinkSystem& system, const Vectors& rows, const Vectors& columns,
                        const std::vector<LimitRow>& limits, std::vector<double>& links);

 private:
  double product(const LimitRow& row, const LimitRow& column) const;
  void reach(const LimitRow& column, Vectors& moved) const;
  double felt(const LimitRow& row, const SystemLinks& links, const Vectors& columns,
              const std::vector<double>& strength) const;

  const std::vector<Limit>& limits_;
  const std::vector<double>& inverse_mass_;
  // Room for a solve.
  std::vector<std::vector<double>> answers_;  // A⁻¹ R W G₀ᵀ
  Vectors moved_;
};

}  // namespace taut
