// Pivots of tridiagonal matrices, for one set of vector instructions: included once for each.
//
// Elimination leaves the pivots δ_k = a_k − t_k/δ_{k−1}, with a the diagonal and t_k the product of what ties
// k and k − 1. Written like that each waits for the division before it. But δ_k = c_k/c_{k−1} with the
// continuants
//   c_k = a_k c_{k−1} − t_k c_{k−2}
// (Wilkinson, The Algebraic Eigenvalue Problem, chapter 5: what rounding does to them is what small relative
// changes of a and t would do), which need no division, and then all 1/δ_k = c_{k−1}/c_k are divisions side
// by side. As continuants grow like powers, each group begins anew with c = 1 and 1/δ before it. Where one
// leaves what numbers can hold, or a pivot has to be mended, the group is done in turn.

#if defined(TAUT_DIRECT_PIVOTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_DIRECT_PIVOTS_INL_H
#undef TAUT_DIRECT_PIVOTS_INL_H
#else
#define TAUT_DIRECT_PIVOTS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "direct/link_matrices.h"
#include "each_value-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

// Rows as they lie in memory: of the one at j the diagonal is diagonal[j], and t is tie[j] · other_tie[j].
struct TiedRows {
  const double *diagonal, *tie, *other_tie;

  HWY_INLINE double product(std::size_t j) const { return tie[j] * other_tie[j]; }
};

// 1/δ of a row behind one with 1/δ = `last`; 0 before the first.
HWY_INLINE double inverse_pivot(const TiedRows& rows, std::size_t j, double last) {
  return 1.0 / mended_pivot(rows.diagonal[j] - rows.product(j) * last, rows.diagonal[j]);
}

// Rows are eliminated upwards or downwards in memory. Of a group:
inline constexpr std::size_t pivots_at_once = 16;
// where its k-th is.
template <bool upwards>
constexpr std::size_t place_in_group(std::size_t k) {
  return upwards ? k : pivots_at_once - 1 - k;
}

// The same one after the other, of a group.
template <bool upwards>
HWY_NOINLINE void invert_in_turn(TiedRows rows, double last, double* inverse) {
  for (std::size_t k = 0; k < pivots_at_once; ++k) {
    const std::size_t j = place_in_group<upwards>(k);
    inverse[j] = last = inverse_pivot(rows, j, last);
  }
}

// The same by continuants.
template <bool upwards>
class Continuants {
 public:
  HWY_INLINE Continuants(const TiedRows& rows, double last) : rows_(rows), last_(last), before_(last) {
    values_[upwards ? 0 : pivots_at_once] = 1.0;
    for_each_value(0, pivots_at_once, [&](auto tag, std::size_t j) TAUT_INLINED {
      hn::Store(hn::Mul(hn::LoadU(tag, rows.tie + j), hn::LoadU(tag, rows.other_tie + j)), tag,
                products_ + j);
    });
  }

  // To be called for every k from 0 on.
  HWY_INLINE void go_on(std::size_t k) {
    const std::size_t j = place_in_group<upwards>(k);
    const double next = rows_.diagonal[j] * newest_ - products_[j] * before_;
    before_ = newest_;
    newest_ = next;
    values_[upwards ? j + 1 : j] = next;
  }

  // Writes 1/δ of the group, as they lie in memory, and returns the last: what the next group begins with
  // need not come from memory.
  HWY_INLINE double invert(double* inverse) const {
    const hn::ScalableTag<double> tag;
    static_assert(pivots_at_once % hn::MaxLanes(tag) == 0);
    bool sound = true;
    for (std::size_t j = 0; j < pivots_at_once; j += hn::Lanes(tag)) {
      const auto before = hn::LoadU(tag, values_ + (upwards ? j : j + 1));
      const auto value = hn::LoadU(tag, values_ + (upwards ? j + 1 : j));
      const auto size = hn::Abs(value), entry = hn::Mul(hn::LoadU(tag, rows_.diagonal + j), before);
      const auto held = hn::And(hn::Gt(size, hn::Set(tag, 1e-250)), hn::Lt(size, hn::Set(tag, 1e250)));
      const auto kept = hn::Ge(size, hn::Mul(hn::Set(tag, least_pivot_share), hn::Abs(entry)));
      sound = sound && hn::AllTrue(tag, hn::And(held, kept));
      hn::StoreU(hn::Div(before, value), tag, inverse + j);
    }
    if (sound) return before_ / newest_;
    invert_in_turn<upwards>(rows_, last_, inverse);
    return inverse[place_in_group<upwards>(pivots_at_once - 1)];
  }

 private:
  TiedRows rows_;
  double last_, before_, newest_ = 1.0;
  HWY_ALIGN double products_[pivots_at_once];
  double values_[pivots_at_once + 1];
};

// What an elimination upwards or downwards knows: rows in memory, counted from where it begins.
template <bool upwards>
class Elimination {
 public:
  HWY_INLINE Continuants<upwards> continuants(std::size_t first) const {
    const std::size_t j = group(first);
    return {{rows_.diagonal + j, rows_.tie + j, rows_.other_tie + j}, last_inverse_};
  }
  HWY_INLINE void invert(std::size_t first, const Continuants<upwards>& continuants) {
    last_inverse_ = continuants.invert(inverse_ + group(first));
  }
  // 1/δ of the last row that has one.
  HWY_INLINE double last_inverse() const { return last_inverse_; }

 protected:
  HWY_INLINE std::size_t place(std::size_t k) const { return upwards ? k : count_ - 1 - k; }
  // Where in memory a group begins.
  HWY_INLINE std::size_t group(std::size_t first) const {
    return upwards ? first : count_ - first - pivots_at_once;
  }
  HWY_INLINE void invert_next(std::size_t k) {
    inverse_[place(k)] = last_inverse_ = inverse_pivot(rows_, place(k), last_inverse_);
  }

  TiedRows rows_{};
  std::size_t count_ = 0;
  double* inverse_ = nullptr;  // 1/δ
  double last_inverse_ = 0.0;
};

// Eliminates rows, or as many of each of several eliminations at once, in groups from `begin` on. What row k
// passes on, pass_on(k), comes a group behind pivots, so that neither are waited for; that of rows in no
// group comes with its pivot, pass_on_alone(k). fetch() is called with each group's first row, for what comes
// next to be on its way.
template <class Fetch, class... Eliminations>
HWY_INLINE void eliminate(std::size_t begin, std::size_t end, const Fetch& fetch, Eliminations&... all) {
  std::size_t first = begin, passed_on = begin;
  for (; first + pivots_at_once <= end; first += pivots_at_once) {
    fetch(first);
    [&](auto... continuants) TAUT_INLINED {
      if (passed_on == first)
        for (std::size_t k = 0; k < pivots_at_once; ++k) (continuants.go_on(k), ...);
      else
        for (std::size_t k = 0; k < pivots_at_once; ++k, ++passed_on)
          ((continuants.go_on(k), all.pass_on(passed_on)), ...);
      (all.invert(first, continuants), ...);
    }(all.continuants(first)...);
  }
  for (; passed_on < first; ++passed_on) (all.pass_on(passed_on), ...);
  for (; first < end; ++first) (all.pass_on_alone(first), ...);
}

// The same of two that need not end together: groups are those that each has alone.
template <class Fetch, class Front, class Back>
HWY_INLINE void eliminate_both(std::size_t begin, std::size_t front_end, std::size_t back_end,
                               const Fetch& fetch, Front& front, Back& back) {
  std::size_t both = std::min(front_end, back_end);
  if (front_end != back_end) both -= (both - begin) % pivots_at_once;
  eliminate(begin, both, fetch, front, back);
  eliminate(both, front_end, fetch, front);
  eliminate(both, back_end, fetch, back);
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
