// Links along paths share a mass only with their neighbours, so their matrix is tridiagonal,
//   A_ii = (w_a + w_b) r_i·c_i + diag_i,   A_{i,i+1} = ± w_m r_i·c_{i+1},   A_{i+1,i} = ± w_m r_{i+1}·c_i,
// and LU without pivoting is O(n). Each pivot waits for the division by the one before; so elimination runs
// from both ends at once and meets in the middle, two chains of divisions side by side.

#include <cmath>

#include "direct/link_kernels.h"
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
    return eliminate(
        fill(rows, columns, diagonal), [](std::size_t, double) { return 0.0; }, [](double) {});
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

  // The right side is eliminated along with the matrix, while its divisions are waited for.
  bool factor_and_solve(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal,
                        std::vector<double>& b) override {
    const std::vector<double>& below = fill(rows, columns, diagonal);
    const auto reduce = [&](std::size_t i, double carried) { return b[i] -= carried; };
    if (!eliminate(below, reduce, [&](double carried) { b[middle_] -= carried; })) return false;
    if (!b.empty()) substitute_back(b);
    return true;
  }

 private:
  // The three diagonals; returns the lower one, which is the upper one where rows and columns are the same.
  const std::vector<double>& fill(const Vectors& rows, const Vectors& columns,
                                  std::span<const double> diagonal) {
    const bool symmetric = &rows == &columns;
    if (!weight_.empty())
      fill_path(to_read(rows), to_read(columns),
                {weight_.size(), weight_.data(), coupling_.data(), diagonal.data(), entry_.data(),
                 above_.data(), symmetric ? nullptr : below_.data()});
    return symmetric ? above_ : below_;
  }

  // What reduce(i, carried) gives for a right side's entry, less what was carried to it, is carried on; what
  // comes to the middle from both sides goes to meet().
  template <class Reduce, class Meet>
  bool eliminate(const std::vector<double>& below, const Reduce& reduce, const Meet& meet) {
    const std::size_t count = weight_.size();
    if (count == 0) return true;
    double unsound = 0.0;  // 0 unless a pivot or its inverse is not finite
    double from_first = 0.0, from_last = 0.0, right_first = 0.0, right_last = 0.0;
    const auto step = [&](std::size_t i, double towards, double away, double& carried, double& right) {
      const double inverse = invert_pivot(i, carried, unsound);
      inward_[i] = towards * inverse;
      outward_[i] = away * inverse;
      carried = towards * away * inverse;
      right = inward_[i] * reduce(i, right);
    };
    std::size_t last = count;
    for (std::size_t first = 0; first < middle_; ++first) {
      step(first, below[first], above_[first], from_first, right_first);
      if (--last > middle_) step(last, above_[last - 1], below[last - 1], from_last, right_last);
    }
    invert_pivot(middle_, from_first + from_last, unsound);
    meet(right_first + right_last);
    return unsound == 0.0;
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
  std::vector<double> above_, below_;  // A_{i,i+1}, A_{i+1,i}; the latter only where they differ
  std::vector<double> inverse_pivot_;
  std::vector<double> inward_,
      outward_;  // off-diagonals over the pivot: towards the middle's row, and its own
};

}  // namespace

std::unique_ptr<LinkMatrix> make_path_matrix(const SystemLinks& links) {
  return std::make_unique<PathMatrix>(links);
}

}  // namespace taut
