#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace taut {

/// Quickens rounds of the kind s ← s + f(s), which by themselves converge by the same factor each, to what
/// the best combination of the last few reaches (Anderson, Iterative Procedures for Nonlinear Integral
/// Equations, 1965; Walker and Ni, Anderson Acceleration for Fixed-Point Iterations, 2011):
///
///   γ = arg min |f − ΔF γ|,   Δs = f − (ΔS + ΔF) γ
///
/// with the columns of ΔS and ΔF the changes of s and of f over the last rounds.
class AndersonMixing {
 public:
  /// Forgets what was.
  void begin() { rounds_ = 0; }
  /// Takes f of the present round in `change`, and leaves Δs there.
  void mix(std::vector<double>& change);

 private:
  static constexpr std::size_t most_kept = 5;
  using Weights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_kept, 1>;
  using Products = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_kept, most_kept>;

  std::size_t rounds_ = 0;
  Eigen::MatrixXd change_of_residual_, change_of_sum_;    // ΔF, and ΔS + ΔF: a column each
  Eigen::Matrix<double, most_kept, most_kept> products_;  // ΔFᵀ ΔF
  Eigen::VectorXd residual_, step_;                       // f and Δs of the round before
};

}  // namespace taut
