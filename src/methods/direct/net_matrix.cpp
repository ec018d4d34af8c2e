// Links in nets: sparse LDLᵀ of links in an order that fills little (approximate minimum degree). The pattern
// is analysed once; each factorisation only fills in numbers, at places worked out beforehand. Tried on
// sheets of rigid links: CHOLMOD's simplicial factorisation takes as long as Eigen's, and its supernodal one
// three times as long with the BLAS that every Debian has; one that is tuned to the processor would make
// results depend on it.

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

#include "direct/link_matrices.h"
#include "direct/net_factor.h"

namespace taut {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

// Two links that share a free mass, the earlier one as the row (the upper triangle).
struct Pair {
  std::size_t row, column;
  double weight;  // ± w_m
  double* place = nullptr;
};

std::vector<Pair> shared_masses(const SystemLinks& links, std::size_t mass_count) {
  std::vector<std::vector<std::pair<std::size_t, double>>> at(mass_count);  // link, ± w_m
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links.weight_a[i] > 0.0) at[links.a[i]].emplace_back(i, links.weight_a[i]);
    if (links.weight_b[i] > 0.0) at[links.b[i]].emplace_back(i, -links.weight_b[i]);
  }
  std::vector<Pair> pairs;
  for (const auto& here : at)
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const bool same_end = (here[i].second > 0.0) == (here[j].second > 0.0);
        const double weight = std::abs(here[i].second);
        pairs.push_back({std::min(here[i].first, here[j].first), std::max(here[i].first, here[j].first),
                         same_end ? weight : -weight});
      }
  return pairs;
}

SparseMatrix pattern(std::size_t links, const std::vector<Pair>& pairs) {
  const auto count = static_cast<Eigen::Index>(links);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < count; ++i) entries.emplace_back(i, i, 1.0);
  for (const Pair& pair : pairs)
    entries.emplace_back(static_cast<Eigen::Index>(pair.row), static_cast<Eigen::Index>(pair.column), 1.0);
  SparseMatrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  matrix.makeCompressed();
  return matrix;
}

class NetMatrix final : public LinkMatrix {
 public:
  NetMatrix(const SystemLinks& links, std::size_t mass_count)
      : pairs_(shared_masses(links, mass_count)), factor_(pattern(links.size(), pairs_)) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      weight_.push_back(links.weight_a[i] + links.weight_b[i]);
      diagonal_place_.push_back(factor_.entry(i, i));
    }
    for (Pair& pair : pairs_) pair.place = factor_.entry(pair.row, pair.column);
  }

  bool takes_unsymmetric() const override { return false; }

  bool factor(const Vectors& rows, const Vectors&, std::span<const double> diagonal) override {
    double largest = 0.0, sum = 0.0;
    entry_.resize(weight_.size());
    for (std::size_t i = 0; i < weight_.size(); ++i) {
      entry_[i] = weight_[i] * rows.at(i).squaredNorm() + diagonal[i];
      largest = std::max(largest, entry_[i]);
      sum += entry_[i];
    }
    if (!std::isfinite(sum)) return false;
    // Redundant links make the matrix singular: then a tiny compliance in all of them, far below what the
    // tolerance on lengths can see, because residuals are not touched.
    for (const double share : {0.0, 1e-10, 1e-8}) {
      factor_.clear();
      for (std::size_t i = 0; i < entry_.size(); ++i) *diagonal_place_[i] = entry_[i] + share * largest;
      for (const Pair& pair : pairs_)
        *pair.place += pair.weight * rows.at(pair.row).dot(rows.at(pair.column));
      if (factor_.factor(1e-13 * largest)) return true;
    }
    return false;
  }

  void solve(std::vector<double>& b) override { factor_.solve(b); }

 private:
  std::vector<Pair> pairs_;
  NetFactor factor_;
  std::vector<double*> diagonal_place_;
  std::vector<double> weight_, entry_;  // w_a + w_b, and the entries on the diagonal
};

}  // namespace

std::vector<Index> net_order(const SystemLinks& links, std::size_t mass_count) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  const SparseMatrix upper = pattern(links.size(), shared_masses(links, mass_count));
  Eigen::AMDOrdering<int>()(upper.selfadjointView<Eigen::Upper>(), order);
  return {order.indices().begin(), order.indices().end()};
}

std::optional<std::size_t> dependent_row(const SystemLinks& links, const Vectors& directions,
                                         std::size_t mass_count) {
  if (links.size() == 0) return std::nullopt;
  // Rows of unit length in the metric of mass, so that pivots can be compared.
  std::vector<double> scale;
  for (std::size_t i = 0; i < links.size(); ++i)
    scale.push_back(1.0 /
                    std::sqrt((links.weight_a[i] + links.weight_b[i]) * directions.at(i).squaredNorm()));
  const std::vector<Pair> pairs = shared_masses(links, mass_count);
  SparseMatrix matrix = pattern(links.size(), pairs);
  for (Eigen::Index i = 0; i < matrix.nonZeros(); ++i) matrix.valuePtr()[i] = 0.0;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) = 1.0;
  for (const Pair& pair : pairs)
    matrix.coeffRef(static_cast<Eigen::Index>(pair.row), static_cast<Eigen::Index>(pair.column)) +=
        pair.weight * directions.at(pair.row).dot(directions.at(pair.column)) * scale[pair.row] *
        scale[pair.column];
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper> factor(matrix);
  const auto pivots = factor.vectorD();
  for (Eigen::Index i = 0; i < pivots.size(); ++i)
    if (!(pivots[i] > 1e-11)) return static_cast<std::size_t>(factor.permutationPinv().indices()[i]);
  return std::nullopt;
}

std::unique_ptr<LinkMatrix> make_net_matrix(const SystemLinks& links, std::size_t mass_count) {
  return std::make_unique<NetMatrix>(links, mass_count);
}

}  // namespace taut
