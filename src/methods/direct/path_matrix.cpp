// Links along paths share a mass only with their neighbours, so their matrix is tridiagonal,
//   A_ii = (w_a + w_b) r_i·c_i + diag_i,   A_{i,i+1} = ± w_m r_i·c_{i+1},   A_{i+1,i} = ± w_m r_{i+1}·c_i,
// and LU without pivoting is O(n). Each pivot waits for the one before; so elimination runs from both ends at
// once and meets in the middle, two chains of pivots side by side. Both ways it goes block by block, so that
// the caller's work on the same links meets them while they are at hand.

#include <algorithm>
#include <cmath>

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
    return eliminate(rows, columns, diagonal, nullptr, {});
  }

  void solve(std::vector<double>& b) override { solve_by_blocks(b, {}); }

  void solve_by_blocks(std::vector<double>& b, const LinkVisits& visits) override {
    if (b.empty()) return;
    PathEnd front, back;
    for (std::size_t block = 0; block < blocks(); ++block) {
      const Sides sides = sides_of(block);
      visit_inward(block, visits.before);
      pass_inward(sides, front.carried, back.carried, b);
    }
    b[middle_] -= front.carried + back.carried;
    substitute_back(b, visits.after);
  }

  bool factor_and_solve_by_blocks(const Vectors& rows, const Vectors& columns,
                                  std::span<const double> diagonal, std::vector<double>& b,
                                  const LinkVisits& visits) override {
    if (b.empty()) return true;
    if (!eliminate(rows, columns, diagonal, b.data(), visits.before)) return false;
    substitute_back(b, visits.after);
    return true;
  }

 private:
  // The links of a block, in front of the middle and behind it.
  struct Sides {
    Extent front, back;

    Extent with_all_between() const { return {front.begin, back.end}; }
  };
  std::size_t size() const { return weight_.size(); }
  std::size_t blocks() const { return std::max<std::size_t>(1, (middle_ + path_block - 1) / path_block); }
  // Counted from the ends; the last one's sides have but the middle between them.
  Sides sides_of(std::size_t block) const {
    const std::size_t begin = block * path_block, behind = size() - 1 - middle_;
    const std::size_t front_end = std::min(begin + path_block, middle_);
    const std::size_t back_end = std::min(begin + path_block, behind);
    return {{begin, front_end}, {size() - back_end, size() - std::min(begin, behind)}};
  }

  // The sides of a block, and with the last one the middle.
  void visit_inward(std::size_t block, const ExtentVisit& visit) const {
    const Sides sides = sides_of(block);
    if (block + 1 == blocks()) return visit(sides.with_all_between());
    visit(sides.front);
    visit(sides.back);
  }

  // One that is symmetric has the same off-diagonals on both sides.
  double* outward() { return symmetric_ ? inward_.data() : outward_.data(); }

  bool eliminate(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal, double* b,
                 const ExtentVisit& before) {
    if (size() == 0) return true;
    symmetric_ = &rows == &columns;
    double* above = above_.data() + 1;
    double* below = symmetric_ ? above : below_.data() + 1;
    const PathElimination path{size(),
                               to_read(rows),
                               to_read(columns),
                               weight_.data(),
                               coupling_.data(),
                               diagonal.data(),
                               entry_.data(),
                               above,
                               below,
                               inverse_pivot_.data(),
                               inward_.data(),
                               outward()};
    PathEnd front, back;
    bool sound = true;
    for (std::size_t block = 0; block < blocks(); ++block) {
      const Sides sides = sides_of(block);
      visit_inward(block, before);
      const PathRows of_block{sides.front.begin, sides.front.end, size() - sides.back.begin};
      sound = eliminate_path(path, of_block, front, back, b) && sound;
    }
    const Vec3 products = rows.at(middle_).cwiseProduct(columns.at(middle_));
    entry_[middle_] = weight_[middle_] * (products.x() + products.y() + products.z()) + diagonal[middle_];
    eliminate_middle(path, front, back);
    if (b) b[middle_] -= front.carried + back.carried;
    return sound && inverse_pivot_[middle_] != 0.0 && std::isfinite(inverse_pivot_[middle_]);
  }

  void eliminate_middle(const PathElimination& path, const PathEnd& front, const PathEnd& back) {
    const auto tied = [&](std::ptrdiff_t i, double inverse) {
      return path.above[i] * path.below[i] * inverse;
    };
    const auto place = static_cast<std::ptrdiff_t>(middle_);
    const double carried = tied(place - 1, front.last_inverse) + tied(place, back.last_inverse);
    inverse_pivot_[middle_] = 1.0 / mended_pivot(entry_[middle_] - carried, entry_[middle_]);
  }

  // What elimination would have done to a right side.
  void pass_inward(const Sides& sides, double& from_first, double& from_last, std::vector<double>& b) const {
    std::size_t last = sides.back.end;
    for (std::size_t first = sides.front.begin; first < sides.front.end; ++first) {
      b[first] -= from_first;
      from_first = inward_[first] * b[first];
      if (last == sides.back.begin) continue;
      --last;
      b[last] -= from_last;
      from_last = inward_[last] * b[last];
    }
  }

  // From the middle to both ends.
  void substitute_back(std::vector<double>& b, const ExtentVisit& after) {
    const double* outward_ties = outward();
    b[middle_] *= inverse_pivot_[middle_];
    double towards_first = b[middle_], towards_last = b[middle_];
    for (std::size_t block = blocks(); block-- > 0;) {
      const Sides sides = sides_of(block);
      std::size_t last = sides.back.begin;
      for (std::size_t first = sides.front.end; first-- > sides.front.begin;) {
        b[first] = towards_first = b[first] * inverse_pivot_[first] - outward_ties[first] * towards_first;
        if (last == sides.back.end) continue;
        b[last] = towards_last = b[last] * inverse_pivot_[last] - outward_ties[last] * towards_last;
        ++last;
      }
      after(sides.with_all_between());
    }
  }

  bool symmetric_ = false;             // whether rows and columns were the same
  std::size_t middle_;                 // where elimination from both ends meets
  std::vector<double> weight_;         // w_a + w_b
  std::vector<double> coupling_;       // ± w_m of the mass shared with the next link; 0 where there is none
  std::vector<double> entry_;          // A_ii
  std::vector<double> above_, below_;  // [i + 1]: A_{i,i+1}, A_{i+1,i}; the latter only where they differ
  std::vector<double> inverse_pivot_;
  // Off-diagonals over the pivot: towards the middle's row, and its own.
  std::vector<double> inward_, outward_;
};

}  // namespace

std::unique_ptr<LinkMatrix> make_path_matrix(const SystemLinks& links) {
  return std::make_unique<PathMatrix>(links);
}

}  // namespace taut
