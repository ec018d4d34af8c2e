// Kernels of links along paths, made once for every set of vector instructions that the compiler can and
// chosen by the processor at hand. All give the same bits.

#include "direct/path_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "direct/path_kernels.cpp"
// Vectors of unknown size can't be held in a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "direct/pivots-inl.h"
#include "each_value-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

// The elimination of one side, towards the middle, with its right side or without.
template <bool upwards, bool symmetric, bool with_right_side>
class PathSide : public Elimination<upwards> {
 public:
  HWY_INLINE PathSide(const PathElimination& path, const PathEnd& end, double* right_side)
      : path_(path),
        towards_(upwards ? path.below : path.above - 1),
        away_(upwards ? path.above : path.below - 1),
        right_side_(right_side),
        carried_(end.carried) {
    constexpr std::ptrdiff_t to_last = upwards ? -1 : 0;
    this->rows_ = {path.entry, path.above + to_last, path.below + to_last};
    this->count_ = path.count;
    this->inverse_ = path.inverse_pivot;
    this->last_inverse_ = end.last_inverse;
  }

  // Rows from k to `end`, and what ties them to the next ones on their way to the middle.
  HWY_INLINE void fill(std::size_t k, std::size_t end) {
    const std::size_t begin = upwards ? k : path_.count - end;
    for_each_value(begin, begin + end - k, [&](auto tag, std::size_t i) TAUT_INLINED {
      const std::size_t next = upwards ? i + 1 : i - 1, tie = upwards ? i : i - 1;
      const auto row = load_three(tag, path_.rows, i), next_row = load_three(tag, path_.rows, next);
      const auto column = symmetric ? row : load_three(tag, path_.columns, i);
      const auto next_column = symmetric ? next_row : load_three(tag, path_.columns, next);
      const auto coupling = hn::LoadU(tag, path_.coupling + tie);
      const auto own = product(row, next_column), other = product(next_row, column);
      hn::StoreU(hn::Mul(coupling, upwards ? own : other), tag, path_.above + tie);
      if (!symmetric) hn::StoreU(hn::Mul(coupling, upwards ? other : own), tag, path_.below + tie);
      hn::StoreU(hn::Add(hn::Mul(hn::LoadU(tag, path_.weight + i), product(row, column)),
                         hn::LoadU(tag, path_.diagonal + i)),
                 tag, path_.entry + i);
    });
  }

  HWY_INLINE void invert(std::size_t first, const Continuants<upwards>& continuants) {
    Elimination<upwards>::invert(first, continuants);
    const std::size_t group = this->group(first);
    for_each_value(group, group + pivots_at_once, [&](auto tag, std::size_t i) TAUT_INLINED {
      const auto inverse = hn::LoadU(tag, path_.inverse_pivot + i);
      hn::StoreU(hn::Mul(hn::LoadU(tag, towards_ + i), inverse), tag, path_.inward + i);
      if (!symmetric) hn::StoreU(hn::Mul(hn::LoadU(tag, away_ + i), inverse), tag, path_.outward + i);
    });
  }
  HWY_INLINE void pass_on(std::size_t k) {
    if constexpr (with_right_side) {
      const std::size_t i = this->place(k);
      right_side_[i] -= carried_;
      carried_ = path_.inward[i] * right_side_[i];
    }
  }
  HWY_INLINE void pass_on_alone(std::size_t k) {
    const std::size_t i = this->place(k);
    this->invert_next(k);
    path_.inward[i] = towards_[i] * path_.inverse_pivot[i];
    if (!symmetric) path_.outward[i] = away_[i] * path_.inverse_pivot[i];
    pass_on(k);
  }
  HWY_INLINE PathEnd end() const { return {this->last_inverse(), carried_}; }

 private:
  const PathElimination path_;
  const double *towards_, *away_;  // off-diagonals: of the row nearer to the middle, and of that row's column
  double* right_side_;
  double carried_;
};

// Rows are filled a group before they are eliminated: pivots that wait for each other leave time for that.
template <bool symmetric, bool with_right_side>
HWY_INLINE void eliminate_sides(const PathElimination& path, const PathRows& rows, PathEnd& front,
                                PathEnd& back, double* right_side) {
  PathSide<true, symmetric, with_right_side> from_first(path, front, right_side);
  PathSide<false, symmetric, with_right_side> from_last(path, back, right_side);
  const auto fill = [&](std::size_t begin) TAUT_INLINED {
    const std::size_t end = begin + pivots_at_once;
    from_first.fill(std::min(begin, rows.front_end), std::min(end, rows.front_end));
    from_last.fill(std::min(begin, rows.back_end), std::min(end, rows.back_end));
  };
  fill(rows.begin);
  eliminate_both(
      rows.begin, rows.front_end, rows.back_end,
      [&](std::size_t first) TAUT_INLINED { fill(first + pivots_at_once); }, from_first, from_last);
  front = from_first.end();
  back = from_last.end();
}

bool eliminate_path_of(const PathElimination& path, const PathRows& rows, PathEnd& front, PathEnd& back,
                       double* right_side) {
  const bool symmetric = path.symmetric();
  if (symmetric && right_side)
    eliminate_sides<true, true>(path, rows, front, back, right_side);
  else if (symmetric)
    eliminate_sides<true, false>(path, rows, front, back, right_side);
  else if (right_side)
    eliminate_sides<false, true>(path, rows, front, back, right_side);
  else
    eliminate_sides<false, false>(path, rows, front, back, right_side);
  bool sound = true;
  const auto look = [&](auto tag, std::size_t i) TAUT_INLINED {
    const auto size = hn::Abs(hn::LoadU(tag, path.inverse_pivot + i));
    sound = sound && hn::AllTrue(tag, hn::And(hn::Gt(size, hn::Zero(tag)), hn::IsFinite(size)));
  };
  for_each_value(rows.begin, rows.front_end, look);
  for_each_value(path.count - rows.back_end, path.count - rows.begin, look);
  return sound;
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(eliminate_path_of);

bool eliminate_path(const PathElimination& path, const PathRows& rows, PathEnd& front, PathEnd& back,
                    double* right_side) {
  return HWY_DYNAMIC_DISPATCH(eliminate_path_of)(path, rows, front, back, right_side);
}

}  // namespace taut

#endif
