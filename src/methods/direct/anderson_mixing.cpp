#include "direct/anderson_mixing.h"

#include <Eigen/QR>
#include <algorithm>

namespace taut {

void AndersonMixing::mix(std::vector<double>& change) {
  const Eigen::Index size = std::ssize(change);
  Eigen::Map<Eigen::VectorXd> residual(change.data(), size);
  if (rounds_ == 0) {
    change_of_residual_.resize(size, static_cast<Eigen::Index>(most_kept));
    change_of_sum_.resize(size, static_cast<Eigen::Index>(most_kept));
    residual_ = step_ = residual;
    rounds_ = 1;
    return;
  }
  const auto column = static_cast<Eigen::Index>((rounds_ - 1) % most_kept);
  change_of_residual_.col(column) = residual - residual_;
  change_of_sum_.col(column) = step_ + change_of_residual_.col(column);
  residual_ = residual;
  const auto kept = static_cast<Eigen::Index>(std::min(rounds_, most_kept));
  const auto differences = change_of_residual_.leftCols(kept);
  products_.row(column).head(kept) = change_of_residual_.col(column).transpose() * differences;
  products_.col(column).head(kept) = products_.row(column).head(kept).transpose();
  // A handful of unknowns: the normal equations, scaled to a diagonal of ones, with directions that add
  // nothing left out.
  const Weights scale = products_.diagonal().head(kept).cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Products scaled = scale.asDiagonal() * products_.topLeftCorner(kept, kept) * scale.asDiagonal();
  Eigen::ColPivHouseholderQR<Products> equations(scaled);
  equations.setThreshold(1e-10);
  const Weights along = scale.cwiseProduct(differences.transpose() * residual);
  const Weights weights = scale.cwiseProduct(equations.solve(along));
  residual -= change_of_sum_.leftCols(kept) * weights;
  step_ = residual;
  ++rounds_;
}

}  // namespace taut
