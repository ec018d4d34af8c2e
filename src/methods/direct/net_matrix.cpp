// Links in nets: sparse LDLᵀ of links in an order that fills little (approximate minimum degree). The pattern
// is analysed once; each factorisation only fills in numbers, at places worked out beforehand. Tried on
// sheets of rigid links: CHOLMOD's simplicial factorisation takes as long as Eigen's, and its supernodal one
// three times as long with the BLAS that every Debian has; one that is tuned to the processor would make
// results depend on it.

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <map>
#include <utility>

#include "direct/link_matrices.h"
#include "direct/net_factor.h"

namespace taut {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

// Two links that share a free mass, the earlier one as the row (the upper triangle).
struct Pair {
  Eigen::Index row, column;
  double weight;  // ± w_m
  double* place = nullptr;
};

std::vector<Pair> shared_masses(const SystemLinks& links, std::size_t mass_count) {
  std::vector<std::vector<std::pair<Eigen::Index, double>>> at(mass_count);  // link, ± w_m
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto link = static_cast<Eigen::Index>(i);
    if (links.weight_a[i] > 0.0) at[links.a[i]].emplace_back(link, links.weight_a[i]);
    if (links.weight_b[i] > 0.0) at[links.b[i]].emplace_back(link, -links.weight_b[i]);
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
  for (const Pair& pair : pairs) entries.emplace_back(pair.row, pair.column, 1.0);
  SparseMatrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  matrix.makeCompressed();
  return matrix;
}

class NetMatrix final : public LinkMatrix {
 public:
  NetMatrix(const SystemLinks& links, std::size_t mass_count)
      : pairs_(shared_masses(links, mass_count)), matrix_(pattern(links.size(), pairs_)), factor_(matrix_) {
    diagonal_place_.resize(links.size());
    weight_.resize(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
      diagonal_place_[i] = &matrix_.coeffRef(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
      weight_[i] = links.weight_a[i] + links.weight_b[i];
    }
    for (Pair& pair : pairs_) pair.place = &matrix_.coeffRef(pair.row, pair.column);
  }

  bool takes_unsymmetric() const override { return false; }

  bool factor(const Vectors& rows, const Vectors&, std::span<const double> diagonal) override {
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
    double largest = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < weight_.size(); ++i) {
      const Vec3 row = rows.at(i);
      *diagonal_place_[i] = weight_[i] * row.squaredNorm() + diagonal[i];
      largest = std::max(largest, *diagonal_place_[i]);
      sum += *diagonal_place_[i];
    }
    for (const Pair& pair : pairs_)
      *pair.place +=
          pair.weight *
          rows.at(static_cast<std::size_t>(pair.row)).dot(rows.at(static_cast<std::size_t>(pair.column)));
    if (!std::isfinite(sum)) return false;
    // Redundant links make the matrix singular: then a tiny compliance in all of them, far below what the
    // tolerance on lengths can see, because residuals are not touched.
    for (const double share : {0.0, 1e-10, 1e-8})
      if (factor_.factor(matrix_, share * largest, 1e-13 * largest)) return true;
    return false;
  }

  void solve(std::vector<double>& b) override { factor_.solve(b); }

 private:
  std::vector<Pair> pairs_;
  SparseMatrix matrix_;  // upper triangle
  std::vector<double*> diagonal_place_;
  std::vector<double> weight_;
  NetFactor factor_;
};

}  // namespace

std::vector<Index> net_order(const SystemLinks& links, std::size_t mass_count) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  const SparseMatrix upper = pattern(links.size(), shared_masses(links, mass_count));
  Eigen::AMDOrdering<int>()(upper.selfadjointView<Eigen::Upper>(), order);
  return {order.indices().begin(), order.indices().end()};
}

std::unique_ptr<LinkMatrix> make_net_matrix(const SystemLinks& links, std::size_t mass_count) {
  return std::make_unique<NetMatrix>(links, mass_count);
}

}  // namespace taut
