#include "direct/balance_matrix.h"

namespace taut {

BalanceMatrix::BalanceMatrix(const Model& model, std::size_t links) : unknown_(model.masses.size(), -1) {
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    if (!model.masses.pinned(i)) {
      unknown_[i] = first_link_;
      first_link_ += 3;
    }
  size_ = first_link_ + static_cast<Eigen::Index>(links);
}

// The lower triangle.
void BalanceMatrix::add_entry(Eigen::Index row, Eigen::Index column, double value) {
  if (row >= column) entries_.emplace_back(row, column, value);
}

void BalanceMatrix::add(Index a, Index b, const Eigen::Matrix3d& block) {
  const Eigen::Index row = unknown_[a], column = unknown_[b];
  if (row < 0 || column < 0) return;
  const bool below = row >= column;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j)
      below ? add_entry(row + i, column + j, block(i, j)) : add_entry(column + j, row + i, block(i, j));
}

void BalanceMatrix::set_link(std::size_t i, Index a, Index b, const Vec3& n, double compliance) {
  const Eigen::Index row = first_link_ + static_cast<Eigen::Index>(i);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (unknown_[a] >= 0) add_entry(row, unknown_[a] + axis, n[axis]);
    if (unknown_[b] >= 0) add_entry(row, unknown_[b] + axis, -n[axis]);
  }
  add_entry(row, row, -compliance);
}

bool BalanceMatrix::factor() {
  matrix_.resize(size_, size_);
  matrix_.setFromTriplets(entries_.begin(), entries_.end());
  if (!analysed_) solver_.analyzePattern(matrix_);
  analysed_ = true;
  solver_.factorize(matrix_);
  return solver_.info() == Eigen::Success;
}

void BalanceMatrix::solve(Vectors& mass, std::vector<double>& links) {
  right_side_.resize(size_);
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    if (unknown_[i] >= 0) right_side_.segment<3>(unknown_[i]) = mass.at(i);
  for (std::size_t i = 0; i < links.size(); ++i)
    right_side_[first_link_ + static_cast<Eigen::Index>(i)] = links[i];
  const Eigen::VectorXd solution = solver_.solve(right_side_);
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    mass.set(i, unknown_[i] >= 0 ? Vec3(solution.segment<3>(unknown_[i])) : Vec3(Vec3::Zero()));
  for (std::size_t i = 0; i < links.size(); ++i)
    links[i] = solution[first_link_ + static_cast<Eigen::Index>(i)];
}

}  // namespace taut
