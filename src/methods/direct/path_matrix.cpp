// Links along paths share a mass only with their neighbours, so their matrix is tridiagonal,
//   A_ii = (w_a + w_b) r_i·c_i + diag_i,   A_{i,i+1} = ± w_m r_i·c_{i+1},   A_{i+1,i} = ± w_m r_{i+1}·c_i,
// and LU without pivoting is O(n). Each pivot waits for the one before; so elimination runs from both ends at
// once and meets in the middle, two chains of pivots side by side.

#include "direct/link_matrices.h"
#include "direct/path_kernels.h"

namespace taut {
namespace {

class PathMatrix final : public LinkMatrix {
 public:
  explicit PathMatrix(const SystemLinks& links)
      : middle_(links.size() / 2), weight_(links.size()), coupling_(links.size(), 0.0) {
    for (std::size_t i = 0; i < links.size(); ++i) weight_[i] = links.weight_a[i] + links.weight_b[i];
    for (std::size_t i = 0; i + 1 < links.size(); ++i) {
      // At most one of these pairs is a shared mass, or two where two links join the same two masses.
      if (links.a[i] == links.a[i + 1]) coupling_[i] += links.weight_a[i];
      if (links.b[i] == links.b[i + 1]) coupling_[i] += links.weight_b[i];
      if (links.a[i] == links.b[i + 1]) coupling_[i] -= links.weight_a[i];
      if (links.b[i] == links.a[i + 1]) coupling_[i] -= links.weight_b[i];
    }
    for (auto* values : {&entry_, &inverse_pivot_, &inward_, &outward_}) values->resize(links.size());
    for (auto* values : {&above_, &below_}) values->resize(links.size() + 1);
  }

  bool takes_unsymmetric() const override { return true; }

  bool factor(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal) override {
    return eliminate(rows, columns, diagonal, nullptr);
  }

  void solve(std::vector<double>& b) override {
    if (b.empty()) return;
    double from_first = 0.0, from_last = 0.0;
    std::size_t last = b.size();
    for (std::size_t first = 0; first < middle_; ++first) {
      b[first] -= from_first;
      from_first = inward_[first] * b[first];
      if (--last <= middle_) continue;
      b[last] -= from_last;
      from_last = inward_[last] * b[last];
    }
    b[middle_] -= from_first + from_last;
    substitute_back(b);
  }

  bool factor_and_solve(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal,
                        std::vector<double>& b) override {
    if (!eliminate(rows, columns, diagonal, b.data())) return false;
    if (!b.empty()) substitute_back(b);
    return true;
  }

 private:
  bool eliminate(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal, double* b) {
    const std::size_t count = weight_.size();
    if (count == 0) return true;
    // The lower diagonal is the upper one where rows and columns are the same.
    double* above = above_.data() + 1;
    double* below = &rows == &columns ? nullptr : below_.data() + 1;
    fill_path(to_read(rows), to_read(columns),
              {count, weight_.data(), coupling_.data(), diagonal.data(), entry_.data(), above, below});
    return eliminate_path({count, middle_, entry_.data(), above, below ? below : above, inverse_pivot_.data(),
                           inward_.data(), outward_.data()},
                          b);
  }

  // From the middle to both ends.
  void substitute_back(std::vector<double>& b) const {
    b[middle_] *= inverse_pivot_[middle_];
    double towards_first = b[middle_], towards_last = b[middle_];
    std::size_t last = middle_;
    for (std::size_t first = middle_; first-- > 0;) {
      b[first] = towards_first = b[first] * inverse_pivot_[first] - outward_[first] * towards_first;
      if (++last >= b.size()) continue;
      b[last] = towards_last = b[last] * inverse_pivot_[last] - outward_[last] * towards_last;
    }
  }

  std::size_t middle_;                 // where elimination from both ends meets
  std::vector<double> weight_;         // w_a + w_b
  std::vector<double> coupling_;       // ± w_m of the mass shared with the next link; 0 where there is none
  std::vector<double> entry_;          // A_ii
  std::vector<double> above_, below_;  // [i + 1]: A_{i,i+1}, A_{i+1,i}; the latter only where they differ
  std::vector<double> inverse_pivot_;
  std::vector<double> inward_,
      outward_;  // off-diagonals over the pivot: towards the middle's row, and its own
};

}  // namespace

std::unique_ptr<LinkMatrix> make_path_matrix(const SystemLinks& links) {
  return std::make_unique<PathMatrix>(links);
}

}  // namespace taut
