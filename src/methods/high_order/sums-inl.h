// Sums over vectors of many masses, for one set of vector instructions: included once for each. Each mass has
// a lane of its own and its sums one order, so that the width of vectors changes no bit.

#if defined(TAUT_HIGH_ORDER_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_HIGH_ORDER_SUMS_INL_H
#undef TAUT_HIGH_ORDER_SUMS_INL_H
#else
#define TAUT_HIGH_ORDER_SUMS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <limits>

#include "high_order/phase_sums.h"
#include "inlined.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Widest = hn::ScalableTag<double>;

// Calls visit(tag, i) for groups of as many as a vector has lanes, from i on. The last group overlaps the one
// before, or where there are fewer in all, vectors are narrower: what is visited must not read what it
// writes.
template <class D, class Visit>
HWY_INLINE void for_groups(D tag, std::size_t begin, std::size_t end, const Visit& visit) {
  const std::size_t lanes = hn::Lanes(tag);
  if (end - begin >= lanes) {
    std::size_t i = begin;
    for (; i + lanes <= end; i += lanes) visit(tag, i);
    if (i < end) visit(tag, end - lanes);
  } else if constexpr (hn::MaxLanes(D()) > 1) {
    for_groups(hn::Half<D>(), begin, end, visit);
  }
}

// The largest of what lanes have met; not a number where one of them has met what is not finite.
struct LargestMet {
  static constexpr std::size_t lanes = hn::MaxLanes(Widest());
  HWY_ALIGN double largest[lanes] = {};
  HWY_ALIGN double unsound[lanes] = {};  // 0, or not a number

  template <class D>
  HWY_INLINE void look(D tag, hn::Vec<D> value) {
    hn::Store(hn::Max(hn::Load(tag, largest), value), tag, largest);
    hn::Store(hn::Add(hn::Load(tag, unsound), hn::Mul(hn::Zero(tag), value)), tag, unsound);
  }
  HWY_INLINE double of_all() const {
    double most = 0.0, lost = 0.0;
    for (std::size_t i = 0; i < lanes; ++i) {
      most = std::max(most, largest[i]);
      lost += unsound[i];
    }
    return lost == 0.0 ? most : std::numeric_limits<double>::quiet_NaN();
  }
};

// Sums of a coordinate of as many masses as vectors have lanes.
template <class D>
struct SumsOfOne {
  hn::Vec<D> position, velocity;

  HWY_INLINE explicit SumsOfOne(D tag) : position(hn::Zero(tag)), velocity(hn::Zero(tag)) {}

  HWY_INLINE void add(D tag, const VectorSums::Term& term, hn::Vec<D> value) {
    position = hn::Add(position, hn::Mul(hn::Set(tag, term.in_position), value));
    velocity = hn::Add(velocity, hn::Mul(hn::Set(tag, term.in_velocity), value));
  }
};

// From what masses have moved to where they are. What is small is summed first.
template <class D>
HWY_INLINE void move_on(D tag, const PhaseSums& at, std::size_t axis, std::size_t i, SumsOfOne<D>& sums) {
  const auto before = hn::LoadU(tag, at.velocity[axis] + i);
  const auto moved = hn::Add(hn::Mul(hn::Set(tag, at.drift), before), sums.position);
  sums.position = hn::Add(hn::LoadU(tag, at.position[axis] + i), moved);
  sums.velocity = hn::Add(before, sums.velocity);
}

// Calls use(tag, i, position, velocity) with a coordinate of masses. One coordinate after the other is what
// memory likes: a dozen streams at once, not forty.
template <class Use>
HWY_INLINE void for_phases(const PhaseSums& at, std::size_t axis, std::size_t begin, std::size_t end,
                           const Use& use) {
  for_groups(Widest(), begin, end, [&](auto tag, std::size_t i) TAUT_INLINED {
    SumsOfOne sums(tag);
    for (std::size_t j = 0; j < at.sums.count; ++j)
      sums.add(tag, at.sums.terms[j], hn::LoadU(tag, at.sums.terms[j].axes[axis] + i));
    move_on(tag, at, axis, i, sums);
    use(tag, i, sums.position, sums.velocity);
  });
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
