// Links along paths share a mass only with their neighbours, so their matrix is tridiagonal,
//   A_ii = (w_a + w_b) r_i·c_i + diag_i,   A_{i,i+1} = ± w_m r_i·c_{i+1},   A_{i+1,i} = ± w_m r_{i+1}·c_i,
// and LU without pivoting is O(n). Each pivot waits for the division by the one before; so elimination runs
// from both ends at once and meets in the middle, two chains of divisions side by side.

#include <cmath>

#include "direct/link_matrices.h"

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
    for (auto* values : {&entry_, &above_, &below_, &inverse_pivot_, &inward_, &outward_})
      values->resize(links.size());
  }

  bool takes_unsymmetric() const override { return true; }

  bool factor(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal) override {
    fill(rows, columns, diagonal);
    const std::size_t count = weight_.size();
    if (count == 0) return true;
    double unsound = 0.0;  // 0 unless a pivot or its inverse is not finite
    double from_first = 0.0, from_last = 0.0;
    const auto eliminate = [&](std::size_t i, double towards, double away, double& carried) {
      const double inverse = invert_pivot(i, carried, unsound);
      inward_[i] = towards * inverse;
      outward_[i] = away * inverse;
      carried = towards * away * inverse;
    };
    std::size_t last = count;
    for (std::size_t first = 0; first < middle_; ++first) {
      eliminate(first, below_[first], above_[first], from_first);
      if (--last > middle_) eliminate(last, above_[last - 1], below_[last - 1], from_last);
    }
    invert_pivot(middle_, from_first + from_last, unsound);
    return unsound == 0.0;
  }

  void solve(std::vector<double>& b) override {
    const std::size_t count = b.size();
    if (count == 0) return;
    double from_first = 0.0, from_last = 0.0;
    std::size_t last = count;
    for (std::size_t first = 0; first < middle_; ++first) {
      b[first] -= from_first;
      from_first = inward_[first] * b[first];
      if (--last <= middle_) continue;
      b[last] -= from_last;
      from_last = inward_[last] * b[last];
    }
    b[middle_] = (b[middle_] - from_first - from_last) * inverse_pivot_[middle_];
    double towards_first = b[middle_], towards_last = b[middle_];
    last = middle_;
    for (std::size_t first = middle_; first-- > 0;) {
      b[first] = towards_first = b[first] * inverse_pivot_[first] - outward_[first] * towards_first;
      if (++last >= count) continue;
      b[last] = towards_last = b[last] * inverse_pivot_[last] - outward_[last] * towards_last;
    }
  }

 private:
  // The three diagonals.
  void fill(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal) {
    const std::size_t count = weight_.size();
    const double *rx = rows.x.data(), *ry = rows.y.data(), *rz = rows.z.data();
    const double *cx = columns.x.data(), *cy = columns.y.data(), *cz = columns.z.data();
    for (std::size_t i = 0; i < count; ++i)
      entry_[i] = weight_[i] * (rx[i] * cx[i] + ry[i] * cy[i] + rz[i] * cz[i]) + diagonal[i];
    for (std::size_t i = 0; i + 1 < count; ++i)
      above_[i] = coupling_[i] * (rx[i] * cx[i + 1] + ry[i] * cy[i + 1] + rz[i] * cz[i + 1]);
    for (std::size_t i = 0; i + 1 < count; ++i)
      below_[i] = coupling_[i] * (rx[i + 1] * cx[i] + ry[i + 1] * cy[i] + rz[i + 1] * cz[i]);
  }

  double invert_pivot(std::size_t i, double carried, double& unsound) {
    const double pivot = mended_pivot(entry_[i] - carried, entry_[i]);
    const double inverse = 1.0 / pivot;
    unsound += 0.0 * (pivot + inverse);
    return inverse_pivot_[i] = inverse;
  }

  std::size_t middle_;                 // where elimination from both ends meets
  std::vector<double> weight_;         // w_a + w_b
  std::vector<double> coupling_;       // ± w_m of the mass shared with the next link; 0 where there is none
  std::vector<double> entry_;          // A_ii
  std::vector<double> above_, below_;  // A_{i,i+1}, A_{i+1,i}
  std::vector<double> inverse_pivot_;
  std::vector<double> inward_,
      outward_;  // off-diagonals over the pivot: towards the middle's row, and its own
};

}  // namespace

std::unique_ptr<LinkMatrix> make_path_matrix(const SystemLinks& links) {
  return std::make_unique<PathMatrix>(links);
}

}  // namespace taut
