// Kernels of the relaxation, made once for every set of vector instructions that the compiler can and chosen
// by the processor at hand. All of them give the same bits: each link's numbers stay in a lane of their own,
// root and division are exact, and a product and a sum are never one operation.
//
// Masses lie as four numbers side by side. Those of four links (or eight, in single precision) are loaded one
// by one, subtracted, and only the differences transposed, so that a vector holds the x of all links; what
// each link then moves its masses by is spread over its difference again. So there is nothing to be gathered
// or scattered, and the order of links does not matter but for the cache.

#include "relax/kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relax/kernels.cpp"
// Vectors of unknown size can't be held in a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "relax/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

template <class V>
HWY_INLINE V dot(const Transposed<V>& a, const Transposed<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

// The ends of the links of a stretch.
template <class Real, bool strided>
struct Ends {
  const std::uint32_t* offsets;
  std::size_t begin, stride;

  HWY_INLINE Ends(const std::uint32_t* all, const LinkStretch& stretch)
      : offsets(all + stretch.ends), begin(stretch.begin), stride(stretch.stride) {}
  HWY_INLINE auto at(std::size_t slot) const {
    const std::size_t link = slot - begin;
    if constexpr (strided)
      return Strided{offsets[link / links_at_once<Real>] + link % links_at_once<Real> * stride, stride};
    else
      return Scattered{offsets + link};
  }
};

// What a link's masses move by, in shares of a row.
template <class Real>
struct Moves {
  typename Lanes<Real>::V a, b;
};

// Moves masses of links along these rows: a's, from on_a, that way, and b's the other.
template <class Real, bool weighted, class Places>
HWY_INLINE void move_links(const Moves<Real>& moves, const typename Lanes<Real>::Rows& along,
                           const typename Lanes<Real>::Rows& on_a, const typename Lanes<Real>::Rows& on_b,
                           const Places& at_a, const Places& at_b, Packed<Real>* position) {
  using L = Lanes<Real>;
  const auto by_a = L::scaled(moves.a, along);
  L::store(L::plus(on_a, by_a), position, at_a);
  if constexpr (weighted)
    L::store(L::minus(on_b, L::scaled(moves.b, along)), position, at_b);
  else
    L::store(L::minus(on_b, by_a), position, at_b);
}

// Roots and quotients take long, so those of a group of links are begun before the group ahead of it is
// moved. As the two share no mass, that changes nothing.
template <class Correct, class Move>
HWY_INLINE void for_each_group(std::size_t begin, std::size_t end, std::size_t count, const Correct& correct,
                               const Move& move) {
  auto moves = correct(begin);
  for (std::size_t next = begin + count; next < end; next += count) {
    const auto next_moves = correct(next);
    move(next - count, moves);
    moves = next_moves;
  }
  move(end - count, moves);
}

template <class Real, bool strided, bool weighted, bool soft, bool damped, bool first>
HWY_NOINLINE void relax_present(const LinkArrays<Real>& all_links, const LinkStretch& stretch,
                                [[maybe_unused]] const Packed<Real>* start, Packed<Real>* position) {
  using L = Lanes<Real>;
  using V = typename L::V;
  const typename L::Tag tag;
  const V one = hn::Set(tag, Real(1)), zero = hn::Zero(tag);
  [[maybe_unused]] const V half = hn::Set(tag, Real(0.5)),
                           plain_factor = hn::Set(tag, all_links.plain_factor);
  const LinkArrays<Real> links = all_links;  // which no store can change
  const Ends<Real, strided> a(links.a, stretch), b(links.b, stretch);
  [[maybe_unused]] const std::size_t special = stretch.special - stretch.begin;
  const auto correct = [&](std::size_t slot) TAUT_INLINED {
    const auto at_a = a.at(slot), at_b = b.at(slot);
    const auto between = L::minus(L::load(position, at_a), L::load(position, at_b));
    const Transposed<V> d = L::transposed(between);
    const V distance = hn::Sqrt(dot(d, d));
    const auto has_direction = hn::Gt(distance, zero);
    const V inverse_distance = hn::IfThenElseZero(has_direction, hn::Div(one, distance));
    V over = hn::Sub(hn::LoadU(tag, links.length + slot), distance);
    [[maybe_unused]] V multiplier = zero;
    if constexpr (!first) multiplier = hn::LoadU(tag, links.multiplier + slot);
    if constexpr (soft && !first)
      over = hn::Sub(over, hn::Mul(hn::LoadU(tag, links.scaled + (special + slot)), multiplier));
    if constexpr (damped) {
      const Transposed<V> d0 = L::transposed(L::minus(L::load(start, at_a), L::load(start, at_b)));
      const Transposed<V> moved{hn::Sub(d.x, d0.x), hn::Sub(d.y, d0.y), hn::Sub(d.z, d0.z)};
      over = hn::Sub(over, hn::Mul(hn::Mul(hn::LoadU(tag, links.gamma + (special + slot)), inverse_distance),
                                   dot(moved, d)));
    }
    over = hn::IfThenElseZero(has_direction, over);
    V factor = plain_factor;
    if constexpr (weighted || soft) factor = hn::LoadU(tag, links.factor + (special + slot));
    V change = hn::Mul(over, factor);
    if constexpr (!first) change = hn::Add(multiplier, change);
    hn::StoreU(change, tag, links.multiplier + slot);
    const V shift = hn::Mul(over, inverse_distance);
    V share_a = half, share_b = half;
    if constexpr (weighted || soft) share_a = hn::LoadU(tag, links.share_a + (special + slot));
    if constexpr (weighted) share_b = hn::LoadU(tag, links.share_b + (special + slot));
    return Moves<Real>{hn::Mul(share_a, shift), hn::Mul(share_b, shift)};
  };
  const auto move = [&](std::size_t slot, const Moves<Real>& moves) TAUT_INLINED {
    const auto at_a = a.at(slot), at_b = b.at(slot);
    const auto on_a = L::load(position, at_a), on_b = L::load(position, at_b);
    move_links<Real, weighted>(moves, L::minus(on_a, on_b), on_a, on_b, at_a, at_b, position);
  };
  for_each_group(stretch.begin, stretch.end, L::count, correct, move);
}

template <class Real, bool strided, bool weighted, bool first>
HWY_INLINE void relax_soft_or_not(const LinkArrays<Real>& links, const LinkStretch& stretch,
                                  const Packed<Real>* start, Packed<Real>* position) {
  if (stretch.damped)
    relax_present<Real, strided, weighted, true, true, first>(links, stretch, start, position);
  else if (stretch.soft)
    relax_present<Real, strided, weighted, true, false, first>(links, stretch, start, position);
  else
    relax_present<Real, strided, weighted, false, false, first>(links, stretch, start, position);
}

template <class Real, bool first>
HWY_INLINE void relax_stretch(const LinkArrays<Real>& links, const LinkStretch& stretch,
                              const Packed<Real>* start, Packed<Real>* position) {
  if (stretch.weighted)
    relax_soft_or_not<Real, false, true, first>(links, stretch, start, position);
  else if (stretch.stride == 0)
    relax_soft_or_not<Real, false, false, first>(links, stretch, start, position);
  else
    relax_soft_or_not<Real, true, false, first>(links, stretch, start, position);
}

// Masses one by one, whatever the width of vectors.
template <class Real, bool velocities>
HWY_INLINE void move_masses(const FreeMotion<Real>& free_motion, std::size_t begin, std::size_t end,
                            Packed<Real>* next) {
  const FreeMotion<Real> motion = free_motion;  // which no store can change
  const hn::CappedTag<Real, 4> tag;
  const auto h = hn::Set(tag, motion.h), keep = hn::Set(tag, motion.keep);
  [[maybe_unused]] const auto inverse_h = hn::Set(tag, motion.inverse_h),
                              end_keep = hn::Set(tag, motion.end_keep);
  const std::size_t lanes = hn::Lanes(tag);
  for (std::size_t i = begin; i < end; ++i)
    for (std::size_t k = 0; k < 4; k += lanes) {
      const auto at = hn::Load(tag, &motion.present[i].x + k);
      auto velocity = hn::Load(tag, &motion.previous[i].x + k);
      if constexpr (!velocities) {
        velocity = hn::Mul(hn::Sub(at, velocity), inverse_h);
        velocity = hn::Add(hn::Mul(velocity, end_keep), hn::LoadU(tag, &motion.end_gain.x + k));
      }
      velocity = hn::Add(hn::Mul(velocity, keep), hn::LoadU(tag, &motion.gain.x + k));
      hn::Store(hn::Add(at, hn::Mul(h, velocity)), tag, &next[i].x + k);
    }
}

template <class Real>
HWY_INLINE void move_range(const FreeMotion<Real>& motion, std::size_t begin, std::size_t end,
                           Packed<Real>* next) {
  motion.velocities ? move_masses<Real, true>(motion, begin, end, next)
                    : move_masses<Real, false>(motion, begin, end, next);
}

template <class Real>
HWY_INLINE bool finite(const Packed<Real>* masses, std::size_t begin, std::size_t end) {
  const hn::CappedTag<Real, 4> tag;
  const auto zero = hn::Zero(tag);
  auto good = hn::Eq(zero, zero);
  for (std::size_t i = begin; i < end; ++i)
    for (std::size_t k = 0; k < 4; k += hn::Lanes(tag)) {
      const auto value = hn::Load(tag, &masses[i].x + k);
      good = hn::And(good, hn::Eq(hn::Sub(value, value), zero));
    }
  return hn::AllTrue(tag, good);
}

bool finite_doubles(const Packed<double>* masses, std::size_t begin, std::size_t end) {
  return finite<double>(masses, begin, end);
}

bool finite_singles(const Packed<float>* masses, std::size_t begin, std::size_t end) {
  return finite<float>(masses, begin, end);
}

// Calls relax(stretch) for each, with masses moved just ahead of the first link and looked at after the last.
template <class Real, class Relax>
HWY_INLINE bool visit_stretches(std::span<const LinkStretch> stretches, const FreeMotion<Real>* motion,
                                const MassRange& masses, bool last, Packed<Real>* position,
                                const Relax& relax) {
  std::size_t begun = masses.begin, done = masses.settled_begin;
  bool good = true;
  const auto begin_until = [&](std::size_t end) TAUT_INLINED {
    if (motion != nullptr && end > begun) move_range(*motion, begun, end, position);
    begun = std::max(begun, end);
  };
  const auto end_until = [&](std::size_t end) TAUT_INLINED {
    if (last && end > done) good = finite(position, done, end) && good;
    done = std::max(done, end);
  };
  for (const LinkStretch& stretch : stretches) {
    begin_until(stretch.begun);
    relax(stretch);
    end_until(std::min({stretch.done, begun, masses.settled_end}));
  }
  begin_until(masses.end);
  end_until(masses.settled_end);
  return good;
}

template <class Real>
HWY_INLINE bool relax_stretches(const LinkArrays<Real>& links, std::span<const LinkStretch> stretches,
                                const Packed<Real>* start, const FreeMotion<Real>* motion,
                                const MassRange& masses, PassPlace place, Packed<Real>* position) {
  return visit_stretches(stretches, motion, masses, place.last, position,
                         [&](const LinkStretch& stretch) TAUT_INLINED {
                           place.first ? relax_stretch<Real, true>(links, stretch, start, position)
                                       : relax_stretch<Real, false>(links, stretch, start, position);
                         });
}

bool relax_doubles(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                   const Packed<double>* start, const FreeMotion<double>* motion, const MassRange& masses,
                   PassPlace place, Packed<double>* position) {
  return relax_stretches<double>(links, stretches, start, motion, masses, place, position);
}

bool relax_singles(const LinkArrays<float>& links, std::span<const LinkStretch> stretches,
                   const Packed<float>* start, const FreeMotion<float>* motion, const MassRange& masses,
                   PassPlace place, Packed<float>* position) {
  return relax_stretches<float>(links, stretches, start, motion, masses, place, position);
}

// Notes those links that have turned by 90° or more.
HWY_NOINLINE void note_lost(Lanes<double>::V along, std::size_t slot, AlongFound& found) {
  double lanes[Lanes<double>::count];
  hn::StoreU(along, Lanes<double>::Tag(), lanes);
  for (const double value : lanes) {
    if (!(value > 0.0)) found.lost.push_back({slot, value});
    ++slot;
  }
}

template <bool strided, bool weighted, bool first, bool judged>
HWY_NOINLINE void relax_along(const LinkArrays<double>& all_links, const LinkStretch& stretch,
                              const Packed<double>* start, Packed<double>* position, AlongFound& found) {
  using L = Lanes<double>;
  using V = L::V;
  const L::Tag tag;
  const V zero = hn::Zero(tag), half = hn::Set(tag, 0.5), plain_factor = hn::Set(tag, all_links.plain_factor);
  const LinkArrays<double> links = all_links;
  const Ends<double, strided> a(links.a, stretch), b(links.b, stretch);
  [[maybe_unused]] const std::size_t special = stretch.special - stretch.begin;
  [[maybe_unused]] V worst = zero;
  const auto correct = [&](std::size_t slot) TAUT_INLINED {
    const auto at_a = a.at(slot), at_b = b.at(slot);
    const Transposed<V> d0 = L::transposed(L::minus(L::load(start, at_a), L::load(start, at_b)));
    const Transposed<V> d = L::transposed(L::minus(L::load(position, at_a), L::load(position, at_b)));
    const V length = hn::LoadU(tag, links.length + slot), square = hn::Mul(length, length);
    const V along = dot(d, d0), excess = hn::Sub(dot(d, d), square);
    const auto turned_less = hn::Gt(along, zero);
    if (HWY_UNLIKELY(!hn::AllTrue(tag, turned_less))) note_lost(along, slot, found);
    if constexpr (judged) worst = hn::Max(worst, hn::Div(hn::Abs(excess), square));
    const V over = hn::IfThenElseZero(turned_less, hn::Div(excess, hn::Add(along, along)));
    V factor = plain_factor;
    if constexpr (weighted) factor = hn::LoadU(tag, links.factor + (special + slot));
    V change = hn::Mul(over, factor);
    if constexpr (!first) change = hn::Add(hn::LoadU(tag, links.multiplier + slot), change);
    hn::StoreU(change, tag, links.multiplier + slot);
    const V back = hn::Neg(over);
    V share_a = half, share_b = half;
    if constexpr (weighted) {
      share_a = hn::LoadU(tag, links.share_a + (special + slot));
      share_b = hn::LoadU(tag, links.share_b + (special + slot));
    }
    return Moves<double>{hn::Mul(share_a, back), hn::Mul(share_b, back)};
  };
  const auto move = [&](std::size_t slot, const Moves<double>& moves) TAUT_INLINED {
    const auto at_a = a.at(slot), at_b = b.at(slot);
    move_links<double, weighted>(moves, L::minus(L::load(start, at_a), L::load(start, at_b)),
                                 L::load(position, at_a), L::load(position, at_b), at_a, at_b, position);
  };
  for_each_group(stretch.begin, stretch.end, L::count, correct, move);
  if constexpr (judged) {
    double lanes[L::count];
    hn::StoreU(worst, tag, lanes);
    for (const double value : lanes) found.worst = std::max(found.worst, value);
  }
}

template <bool first, bool judged>
HWY_INLINE void relax_stretch_along(const LinkArrays<double>& links, const LinkStretch& stretch,
                                    const Packed<double>* start, Packed<double>* position,
                                    AlongFound& found) {
  if (stretch.weighted)
    relax_along<false, true, first, judged>(links, stretch, start, position, found);
  else if (stretch.stride == 0)
    relax_along<false, false, first, judged>(links, stretch, start, position, found);
  else
    relax_along<true, false, first, judged>(links, stretch, start, position, found);
}

bool relax_all_along(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                     const Packed<double>* start, const FreeMotion<double>* motion, const MassRange& masses,
                     PassPlace place, bool judged, Packed<double>* position, AlongFound& found) {
  found.worst = 0.0;
  return visit_stretches(
      stretches, motion, masses, place.last, position, [&](const LinkStretch& stretch) TAUT_INLINED {
        if (place.first)
          judged ? relax_stretch_along<true, true>(links, stretch, start, position, found)
                 : relax_stretch_along<true, false>(links, stretch, start, position, found);
        else
          judged ? relax_stretch_along<false, true>(links, stretch, start, position, found)
                 : relax_stretch_along<false, false>(links, stretch, start, position, found);
      });
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(relax_doubles);
HWY_EXPORT(relax_singles);
HWY_EXPORT(finite_doubles);
HWY_EXPORT(finite_singles);
HWY_EXPORT(relax_all_along);

template <>
bool relax_along_present(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                         const Packed<double>* start, const FreeMotion<double>* motion,
                         const MassRange& masses, PassPlace place, Packed<double>* position) {
  return HWY_DYNAMIC_DISPATCH(relax_doubles)(links, stretches, start, motion, masses, place, position);
}

template <>
bool relax_along_present(const LinkArrays<float>& links, std::span<const LinkStretch> stretches,
                         const Packed<float>* start, const FreeMotion<float>* motion, const MassRange& masses,
                         PassPlace place, Packed<float>* position) {
  return HWY_DYNAMIC_DISPATCH(relax_singles)(links, stretches, start, motion, masses, place, position);
}

template <>
bool are_finite(const Packed<double>* position, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(finite_doubles)(position, begin, end);
}

template <>
bool are_finite(const Packed<float>* position, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(finite_singles)(position, begin, end);
}

bool relax_along_start(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                       const Packed<double>* start, const FreeMotion<double>* motion, const MassRange& masses,
                       PassPlace place, bool judged, Packed<double>* position, AlongFound& found) {
  return HWY_DYNAMIC_DISPATCH(relax_all_along)(links, stretches, start, motion, masses, place, judged,
                                               position, found);
}

}  // namespace taut

#endif
