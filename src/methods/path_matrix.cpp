// Links along paths share a mass only with their neighbours, so their matrix is tridiagonal: LU without
// pivoting, O(n).
//   A_ii = (w_a + w_b) r_i·c_i + diag_i,   A_{i,i+1} = ± w_m r_i·c_{i+1},   A_{i+1,i} = ± w_m r_{i+1}·c_i

#include <cmath>

#include "link_matrices.h"

namespace taut {
namespace {

double dot(const Vectors& a, std::size_t i, const Vectors& b, std::size_t j) {
  return a.x[i] * b.x[j] + a.y[i] * b.y[j] + a.z[i] * b.z[j];
}

class PathMatrix final : public LinkMatrix {
 public:
  explicit PathMatrix(const SystemLinks& links) : weight_(links.size()), coupling_(links.size(), 0.0) {
    for (std::size_t i = 0; i < links.size(); ++i) weight_[i] = links.weight_a[i] + links.weight_b[i];
    for (std::size_t i = 0; i + 1 < links.size(); ++i) {
      // At most one of these pairs is a shared mass, or two where two links join the same two masses.
      if (links.a[i] == links.a[i + 1]) coupling_[i] += links.weight_a[i];
      if (links.b[i] == links.b[i + 1]) coupling_[i] += links.weight_b[i];
      if (links.a[i] == links.b[i + 1]) coupling_[i] -= links.weight_a[i];
      if (links.b[i] == links.a[i + 1]) coupling_[i] -= links.weight_b[i];
    }
    inverse_pivot_.resize(links.size());
    lower_.resize(links.size());
    upper_.resize(links.size());
  }

  bool takes_unsymmetric() const override { return true; }

  bool factor(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal) override {
    double carried = 0.0;  // what elimination of the link before takes from this pivot
    for (std::size_t i = 0; i < weight_.size(); ++i) {
      const double entry = weight_[i] * dot(rows, i, columns, i) + diagonal[i];
      const double pivot = mended_pivot(entry - carried, entry);
      if (!std::isfinite(pivot) || pivot == 0.0) return false;
      inverse_pivot_[i] = 1.0 / pivot;
      if (i + 1 == weight_.size()) break;
      upper_[i] = coupling_[i] * dot(rows, i, columns, i + 1);
      lower_[i] = coupling_[i] * dot(rows, i + 1, columns, i) * inverse_pivot_[i];
      carried = lower_[i] * upper_[i];
    }
    return true;
  }

  void solve(std::vector<double>& b) override {
    const std::size_t count = b.size();
    for (std::size_t i = 1; i < count; ++i) b[i] -= lower_[i - 1] * b[i - 1];
    if (count > 0) b[count - 1] *= inverse_pivot_[count - 1];
    for (std::size_t i = count; i-- > 1;)
      b[i - 1] = (b[i - 1] - upper_[i - 1] * b[i]) * inverse_pivot_[i - 1];
  }

 private:
  std::vector<double> weight_;    // w_a + w_b
  std::vector<double> coupling_;  // ± w_m of the mass shared with the next link; 0 where there is none
  std::vector<double> inverse_pivot_, lower_, upper_;
};

}  // namespace

std::unique_ptr<LinkMatrix> make_path_matrix(const SystemLinks& links) {
  return std::make_unique<PathMatrix>(links);
}

}  // namespace taut
