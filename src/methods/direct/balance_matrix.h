#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "model/model.h"

namespace taut {

/// A symmetric system of masses' ways (three unknowns each; pins have none) and links' pulls,
///   [H  Jᵀ] [Δx]   [force ]
///   [J  −D] [Δλ] = [length],
/// put together entry by entry and solved by one sparse factorisation. As long as H is positive definite and
/// D above 0, there is one in any order of elimination (Vanderbei, Symmetric Quasidefinite Matrices, 1995).
class BalanceMatrix {
 public:
  /// For the masses that are not pins, and so many links with pulls.
  BalanceMatrix(const Model& model, std::size_t links);

  void clear() { entries_.clear(); }
  /// Adds to H what mass `a` feels of a way of mass `b`, of the two orders of a pair the one alone.
  void add(Index a, Index b, const Eigen::Matrix3d& block);
  /// Link i: its direction n, away from b at mass a, and D.
  void set_link(std::size_t i, Index a, Index b, const Vec3& n, double compliance);
  /// False where the matrix is singular.
  bool factor();
  /// Takes the right side, and gives the solution in its place.
  void solve(Vectors& mass, std::vector<double>& links);

 private:
  void add_entry(Eigen::Index row, Eigen::Index column, double value);

  std::vector<Eigen::Index> unknown_;  // first of each mass's three; −1: a pin
  Eigen::Index first_link_ = 0, size_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  Eigen::VectorXd right_side_;
  bool analysed_ = false;
};

}  // namespace taut
