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
class LargestMet {
 public:
  HWY_INLINE LargestMet() : largest_(hn::Zero(Widest())), unsound_(hn::Zero(Widest())) {}

  HWY_INLINE void look(Widest tag, hn::Vec<Widest> value) {
    largest_ = hn::Max(largest_, value);
    unsound_ = hn::Add(unsound_, hn::Mul(hn::Zero(tag), value));
  }
  // Fewer than a vector has lanes for, as at an end.
  template <class D>
  HWY_INLINE void look(D tag, hn::Vec<D> value) {
    HWY_ALIGN double values[lanes] = {};
    hn::Store(value, tag, values);
    look(Widest(), hn::Load(Widest(), values));
  }
  HWY_INLINE double of_all() const {
    HWY_ALIGN double largest[lanes], unsound[lanes];  // 0, or not a number
    hn::Store(largest_, Widest(), largest);
    hn::Store(unsound_, Widest(), unsound);
    double most = 0.0, lost = 0.0;
    for (std::size_t i = 0; i < lanes; ++i) {
      most = std::max(most, largest[i]);
      lost += unsound[i];
    }
    return lost == 0.0 ? most : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  static constexpr std::size_t lanes = hn::MaxLanes(Widest());
  hn::Vec<Widest> largest_, unsound_;
};

// The weights of sums, each in every lane: so a term takes a load, two products and two sums.
struct SpreadWeights {
  static constexpr std::size_t lanes = hn::MaxLanes(Widest());
  HWY_ALIGN double in_position[VectorSums::most][lanes];
  HWY_ALIGN double in_velocity[VectorSums::most][lanes];

  HWY_INLINE explicit SpreadWeights(const VectorSums& sums) {
    for (std::size_t j = 0; j < sums.count; ++j) {
      hn::Store(hn::Set(Widest(), sums.terms[j].in_position), Widest(), in_position[j]);
      hn::Store(hn::Set(Widest(), sums.terms[j].in_velocity), Widest(), in_velocity[j]);
    }
  }
};

// Sums of a coordinate of as many masses as so many vectors have lanes.
template <class D, std::size_t vectors = 1>
struct Sums {
  hn::Vec<D> position[vectors], velocity[vectors];

  HWY_INLINE explicit Sums(D tag) {
    for (std::size_t k = 0; k < vectors; ++k) position[k] = velocity[k] = hn::Zero(tag);
  }

  // Of what lies in memory from `values` on.
  HWY_INLINE void add(D tag, const SpreadWeights& weights, std::size_t term, const double* values) {
    const auto in_position = hn::Load(tag, weights.in_position[term]);
    const auto in_velocity = hn::Load(tag, weights.in_velocity[term]);
    for (std::size_t k = 0; k < vectors; ++k) {
      const auto value = hn::LoadU(tag, values + k * hn::Lanes(tag));
      position[k] = hn::Add(position[k], hn::Mul(in_position, value));
      velocity[k] = hn::Add(velocity[k], hn::Mul(in_velocity, value));
    }
  }
};

// From what a mass has moved to where it is. What is small is summed first.
template <class D>
HWY_INLINE void move_on(D tag, const PhaseSums& at, std::size_t axis, std::size_t i, hn::Vec<D>& position,
                        hn::Vec<D>& velocity) {
  const auto before = hn::LoadU(tag, at.velocity[axis] + i);
  const auto moved = hn::Add(hn::Mul(hn::Set(tag, at.drift), before), position);
  position = hn::Add(hn::LoadU(tag, at.position[axis] + i), moved);
  velocity = hn::Add(before, velocity);
}

// Calls use(tag, i, position, velocity) with a coordinate of as many masses as so many vectors have lanes.
template <std::size_t vectors, class D, class Use>
HWY_INLINE void sum_phases(D tag, const PhaseSums& at, const SpreadWeights& weights, std::size_t axis,
                           std::size_t i, const Use& use) {
  Sums<D, vectors> sums(tag);
  for (std::size_t j = 0; j < at.sums.count; ++j) sums.add(tag, weights, j, at.sums.terms[j].axes[axis] + i);
  for (std::size_t k = 0; k < vectors; ++k, i += hn::Lanes(tag)) {
    move_on(tag, at, axis, i, sums.position[k], sums.velocity[k]);
    use(tag, i, sums.position[k], sums.velocity[k]);
  }
}

// The same of all masses of a range. One coordinate after the other is what memory likes: a dozen streams at
// once, not forty; and four vectors at once, for which weights are read only once.
template <class Use>
HWY_INLINE void for_phases(const PhaseSums& at, const SpreadWeights& weights, std::size_t axis,
                           std::size_t begin, std::size_t end, const Use& use) {
  const Widest widest;
  const std::size_t four = 4 * hn::Lanes(widest);
  for (; begin + four <= end; begin += four) sum_phases<4>(widest, at, weights, axis, begin, use);
  for_groups(widest, begin, end,
             [&](auto tag, std::size_t i) TAUT_INLINED { sum_phases<1>(tag, at, weights, axis, i, use); });
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
