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

void fill_path_of(const AxesToRead& rows, const AxesToRead& columns, const PathEntries& to, Extent links) {
  const auto fill_entry = [&](auto tag, const auto& row, const auto& column, std::size_t i) TAUT_INLINED {
    hn::StoreU(hn::Add(hn::Mul(hn::LoadU(tag, to.weight + i), product(row, column)),
                       hn::LoadU(tag, to.diagonal + i)),
               tag, to.entry + i);
  };
  const auto fill = [&](auto tag, std::size_t i) TAUT_INLINED {
    const auto row = load_three(tag, rows, i), column = load_three(tag, columns, i);
    const auto coupling = hn::LoadU(tag, to.coupling + i);
    fill_entry(tag, row, column, i);
    hn::StoreU(hn::Mul(coupling, product(row, load_three(tag, columns, i + 1))), tag, to.above + i);
    if (to.below)
      hn::StoreU(hn::Mul(coupling, product(load_three(tag, rows, i + 1), column)), tag, to.below + i);
  };
  const std::size_t last = to.count - 1;
  for_each_value(links.begin, std::min(links.end, last), fill);
  if (links.end <= last) return;
  const hn::CappedTag<double, 1> one;
  fill_entry(one, load_three(one, rows, last), load_three(one, columns, last), last);
}

// The elimination of one side, towards the middle, with its right side or without.
template <bool upwards, bool with_right_side>
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

  HWY_INLINE void invert(std::size_t first, const Continuants<upwards>& continuants) {
    Elimination<upwards>::invert(first, continuants);
    const std::size_t group = this->group(first);
    for_each_value(group, group + pivots_at_once, [&](auto tag, std::size_t i) TAUT_INLINED {
      const auto inverse = hn::LoadU(tag, path_.inverse_pivot + i);
      hn::StoreU(hn::Mul(hn::LoadU(tag, towards_ + i), inverse), tag, path_.inward + i);
      hn::StoreU(hn::Mul(hn::LoadU(tag, away_ + i), inverse), tag, path_.outward + i);
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
    path_.outward[i] = away_[i] * path_.inverse_pivot[i];
    pass_on(k);
  }
  HWY_INLINE PathEnd end() const { return {this->last_inverse(), carried_}; }

 private:
  const PathElimination path_;
  const double *towards_, *away_;  // off-diagonals: of the row nearer to the middle, and of that row's column
  double* right_side_;
  double carried_;
};

template <bool with_right_side>
HWY_INLINE void eliminate_sides(const PathElimination& path, const PathRows& rows, PathEnd& front,
                                PathEnd& back, double* right_side) {
  PathSide<true, with_right_side> from_first(path, front, right_side);
  PathSide<false, with_right_side> from_last(path, back, right_side);
  eliminate_both(
      rows.begin, rows.front_end, rows.back_end, [](std::size_t) TAUT_INLINED {}, from_first, from_last);
  front = from_first.end();
  back = from_last.end();
}

bool eliminate_path_of(const PathElimination& path, const PathRows& rows, PathEnd& front, PathEnd& back,
                       double* right_side) {
  if (right_side)
    eliminate_sides<true>(path, rows, front, back, right_side);
  else
    eliminate_sides<false>(path, rows, front, back, right_side);
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

HWY_EXPORT(fill_path_of);
HWY_EXPORT(eliminate_path_of);

void fill_path(const AxesToRead& rows, const AxesToRead& columns, const PathEntries& entries, Extent links) {
  HWY_DYNAMIC_DISPATCH(fill_path_of)(rows, columns, entries, links);
}

bool eliminate_path(const PathElimination& path, const PathRows& rows, PathEnd& front, PathEnd& back,
                    double* right_side) {
  return HWY_DYNAMIC_DISPATCH(eliminate_path_of)(path, rows, front, back, right_side);
}

}  // namespace taut

#endif
