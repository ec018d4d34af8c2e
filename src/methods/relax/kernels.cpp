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

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The x, y and z of as many links as a vector has lanes.
template <class V>
struct Transposed {
  V x, y, z;
};

template <class Real>
struct Lanes;

#if HWY_TARGET == HWY_SCALAR

// One link at a time.
template <class Real>
struct Lanes {
  using Tag = hn::FixedTag<Real, 1>;
  using V = hn::Vec<Tag>;
  using Rows = Transposed<V>;
  static constexpr std::size_t count = 1;

  static HWY_INLINE Rows load_next(const Packed<Real>* vectors) {
    return {hn::Load(Tag(), &vectors->x), hn::Load(Tag(), &vectors->y), hn::Load(Tag(), &vectors->z)};
  }
  static HWY_INLINE Rows load(const Packed<Real>* masses, const Index* at) { return load_next(masses + *at); }
  static HWY_INLINE void store(const Rows& rows, Packed<Real>* masses, const Index* at) {
    hn::Store(rows.x, Tag(), &masses[*at].x);
    hn::Store(rows.y, Tag(), &masses[*at].y);
    hn::Store(rows.z, Tag(), &masses[*at].z);
  }
  static HWY_INLINE Rows minus(const Rows& a, const Rows& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
  }
  static HWY_INLINE Rows plus(const Rows& a, const Rows& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
  }
  static HWY_INLINE Transposed<V> transposed(const Rows& d) { return d; }
  static HWY_INLINE Rows scaled(V factor, const Rows& d) {
    return {hn::Mul(factor, d.x), hn::Mul(factor, d.y), hn::Mul(factor, d.z)};
  }
};

#else

// A vector as wide as a mass, or twice as wide, holds a mass of one link, or of two: single precision, and
// double where vectors are wide.
#if HWY_MAX_BYTES >= 32
using Doubles = hn::FixedTag<double, 4>;
using Singles = hn::FixedTag<float, 8>;
#else
using Doubles = hn::FixedTag<double, 2>;
using Singles = hn::FixedTag<float, 4>;
#endif

#if HWY_MAX_BYTES >= 32

template <>
struct Lanes<double> {
  using Tag = Doubles;
  using V = hn::Vec<Tag>;
  struct Rows {
    V link[4];
  };
  static constexpr std::size_t count = 4;

  static HWY_INLINE Rows load(const Packed<double>* masses, const Index* at) {
    const auto one = [&](std::size_t i) HWY_ATTR { return hn::Load(Tag(), &masses[at[i]].x); };
    return {{one(0), one(1), one(2), one(3)}};
  }
  static HWY_INLINE Rows load_next(const Packed<double>* vectors) {
    const auto one = [&](std::size_t i) HWY_ATTR { return hn::Load(Tag(), &vectors[i].x); };
    return {{one(0), one(1), one(2), one(3)}};
  }
  static HWY_INLINE void store(const Rows& rows, Packed<double>* masses, const Index* at) {
    for (std::size_t i = 0; i < 4; ++i) hn::Store(rows.link[i], Tag(), &masses[at[i]].x);
  }
  static HWY_INLINE Rows minus(const Rows& a, const Rows& b) {
    return {{hn::Sub(a.link[0], b.link[0]), hn::Sub(a.link[1], b.link[1]), hn::Sub(a.link[2], b.link[2]),
             hn::Sub(a.link[3], b.link[3])}};
  }
  static HWY_INLINE Rows plus(const Rows& a, const Rows& b) {
    return {{hn::Add(a.link[0], b.link[0]), hn::Add(a.link[1], b.link[1]), hn::Add(a.link[2], b.link[2]),
             hn::Add(a.link[3], b.link[3])}};
  }
  static HWY_INLINE Transposed<V> transposed(const Rows& d) {
    const V xz01 = hn::InterleaveLower(Tag(), d.link[0], d.link[1]),
            xz23 = hn::InterleaveLower(Tag(), d.link[2], d.link[3]),
            y01 = hn::InterleaveUpper(Tag(), d.link[0], d.link[1]),
            y23 = hn::InterleaveUpper(Tag(), d.link[2], d.link[3]);
    return {hn::ConcatLowerLower(Tag(), xz23, xz01), hn::ConcatLowerLower(Tag(), y23, y01),
            hn::ConcatUpperUpper(Tag(), xz23, xz01)};
  }
  // Each link's factor times its row.
  static HWY_INLINE Rows scaled(V factor, const Rows& d) {
    const V even = hn::InterleaveLower(Tag(), factor, factor),
            odd = hn::InterleaveUpper(Tag(), factor, factor);
    return {{hn::Mul(hn::ConcatLowerLower(Tag(), even, even), d.link[0]),
             hn::Mul(hn::ConcatLowerLower(Tag(), odd, odd), d.link[1]),
             hn::Mul(hn::ConcatUpperUpper(Tag(), even, even), d.link[2]),
             hn::Mul(hn::ConcatUpperUpper(Tag(), odd, odd), d.link[3])}};
  }
};

#else

template <>
struct Lanes<double> {
  using Tag = Doubles;
  using V = hn::Vec<Tag>;
  struct Rows {
    V xy[2], z[2];  // z and nothing
  };
  static constexpr std::size_t count = 2;

  static HWY_INLINE Rows load(const Packed<double>* masses, const Index* at) {
    return {{hn::Load(Tag(), &masses[at[0]].x), hn::Load(Tag(), &masses[at[1]].x)},
            {hn::Load(Tag(), &masses[at[0]].z), hn::Load(Tag(), &masses[at[1]].z)}};
  }
  static HWY_INLINE Rows load_next(const Packed<double>* vectors) {
    return {{hn::Load(Tag(), &vectors[0].x), hn::Load(Tag(), &vectors[1].x)},
            {hn::Load(Tag(), &vectors[0].z), hn::Load(Tag(), &vectors[1].z)}};
  }
  static HWY_INLINE void store(const Rows& rows, Packed<double>* masses, const Index* at) {
    for (std::size_t i = 0; i < 2; ++i) {
      hn::Store(rows.xy[i], Tag(), &masses[at[i]].x);
      hn::Store(rows.z[i], Tag(), &masses[at[i]].z);
    }
  }
  static HWY_INLINE Rows minus(const Rows& a, const Rows& b) {
    return {{hn::Sub(a.xy[0], b.xy[0]), hn::Sub(a.xy[1], b.xy[1])},
            {hn::Sub(a.z[0], b.z[0]), hn::Sub(a.z[1], b.z[1])}};
  }
  static HWY_INLINE Rows plus(const Rows& a, const Rows& b) {
    return {{hn::Add(a.xy[0], b.xy[0]), hn::Add(a.xy[1], b.xy[1])},
            {hn::Add(a.z[0], b.z[0]), hn::Add(a.z[1], b.z[1])}};
  }
  static HWY_INLINE Transposed<V> transposed(const Rows& d) {
    return {hn::InterleaveLower(Tag(), d.xy[0], d.xy[1]), hn::InterleaveUpper(Tag(), d.xy[0], d.xy[1]),
            hn::InterleaveLower(Tag(), d.z[0], d.z[1])};
  }
  static HWY_INLINE Rows scaled(V factor, const Rows& d) {
    const V first = hn::InterleaveLower(Tag(), factor, factor),
            second = hn::InterleaveUpper(Tag(), factor, factor);
    return {{hn::Mul(first, d.xy[0]), hn::Mul(second, d.xy[1])},
            {hn::Mul(first, d.z[0]), hn::Mul(second, d.z[1])}};
  }
};

#endif

template <>
struct Lanes<float> {
  using Tag = Singles;
  using V = hn::Vec<Tag>;
  using Mass = hn::FixedTag<float, 4>;
  using Pairs = hn::RepartitionToWide<Tag>;
  struct Rows {
    V link[4];  // of the link and, where vectors are wide, of the one four places on
  };
  static constexpr std::size_t count = hn::MaxLanes(Tag());

  static HWY_INLINE V load_row(const Packed<float>& low, [[maybe_unused]] const Packed<float>& high) {
#if HWY_MAX_BYTES >= 32
    return hn::Combine(Tag(), hn::Load(Mass(), &high.x), hn::Load(Mass(), &low.x));
#else
    return hn::Load(Mass(), &low.x);
#endif
  }
  static HWY_INLINE Rows load(const Packed<float>* masses, const Index* at) {
    const auto one = [&](std::size_t i)
                         HWY_ATTR { return load_row(masses[at[i]], masses[at[(i + 4) % count]]); };
    return {{one(0), one(1), one(2), one(3)}};
  }
  static HWY_INLINE void store(const Rows& rows, Packed<float>* masses, const Index* at) {
    for (std::size_t i = 0; i < 4; ++i) {
#if HWY_MAX_BYTES >= 32
      hn::Store(hn::LowerHalf(rows.link[i]), Mass(), &masses[at[i]].x);
      hn::Store(hn::UpperHalf(Mass(), rows.link[i]), Mass(), &masses[at[i + 4]].x);
#else
      hn::Store(rows.link[i], Mass(), &masses[at[i]].x);
#endif
    }
  }
  static HWY_INLINE Rows minus(const Rows& a, const Rows& b) {
    return {{hn::Sub(a.link[0], b.link[0]), hn::Sub(a.link[1], b.link[1]), hn::Sub(a.link[2], b.link[2]),
             hn::Sub(a.link[3], b.link[3])}};
  }
  static HWY_INLINE Rows plus(const Rows& a, const Rows& b) {
    return {{hn::Add(a.link[0], b.link[0]), hn::Add(a.link[1], b.link[1]), hn::Add(a.link[2], b.link[2]),
             hn::Add(a.link[3], b.link[3])}};
  }
  static HWY_INLINE V lower_pairs(V low, V high) {
    return hn::BitCast(Tag(),
                       hn::InterleaveLower(Pairs(), hn::BitCast(Pairs(), low), hn::BitCast(Pairs(), high)));
  }
  static HWY_INLINE V upper_pairs(V low, V high) {
    return hn::BitCast(Tag(),
                       hn::InterleaveUpper(Pairs(), hn::BitCast(Pairs(), low), hn::BitCast(Pairs(), high)));
  }
  static HWY_INLINE Transposed<V> transposed(const Rows& d) {
    const V xy01 = hn::InterleaveLower(Tag(), d.link[0], d.link[1]),
            xy23 = hn::InterleaveLower(Tag(), d.link[2], d.link[3]),
            z01 = hn::InterleaveUpper(Tag(), d.link[0], d.link[1]),
            z23 = hn::InterleaveUpper(Tag(), d.link[2], d.link[3]);
    return {lower_pairs(xy01, xy23), upper_pairs(xy01, xy23), lower_pairs(z01, z23)};
  }
  static HWY_INLINE Rows scaled(V factor, const Rows& d) {
    return {{hn::Mul(hn::Broadcast<0>(factor), d.link[0]), hn::Mul(hn::Broadcast<1>(factor), d.link[1]),
             hn::Mul(hn::Broadcast<2>(factor), d.link[2]), hn::Mul(hn::Broadcast<3>(factor), d.link[3])}};
  }
};

#endif

template <class V>
HWY_INLINE V dot(const Transposed<V>& a, const Transposed<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

template <class Real, bool weighted, bool soft, bool damped>
HWY_NOINLINE void relax_present(const LinkArrays<Real>& links, const LinkStretch& stretch,
                                [[maybe_unused]] const Packed<Real>* start, Packed<Real>* position) {
  using L = Lanes<Real>;
  using Rows = typename L::Rows;
  const typename L::Tag tag;
  using V = typename L::V;
  const V one = hn::Set(tag, Real(1)), zero = hn::Zero(tag);
  [[maybe_unused]] const V plain_move = hn::Set(tag, links.plain_move),
                           plain_factor = hn::Set(tag, links.plain_factor);
  const Index *const a = links.a, *const b = links.b;
  for (std::size_t slot = stretch.begin; slot < stretch.end; slot += L::count) {
    [[maybe_unused]] const std::size_t special = stretch.special + (slot - stretch.begin);
    const Rows on_a = L::load(position, a + slot), on_b = L::load(position, b + slot);
    const Rows between = L::minus(on_a, on_b);
    const Transposed<V> d = L::transposed(between);
    const V distance = hn::Sqrt(dot(d, d));
    const auto has_direction = hn::Gt(distance, zero);
    const V inverse_distance = hn::IfThenElseZero(has_direction, hn::Div(one, distance));
    const V multiplier = hn::LoadU(tag, links.multiplier + slot);
    V change = hn::Sub(hn::LoadU(tag, links.length + slot), distance);
    if constexpr (soft) change = hn::Sub(change, hn::Mul(hn::LoadU(tag, links.scaled + special), multiplier));
    if constexpr (damped) {
      const Transposed<V> d0 = L::transposed(L::minus(L::load(start, a + slot), L::load(start, b + slot)));
      const Transposed<V> moved{hn::Sub(d.x, d0.x), hn::Sub(d.y, d0.y), hn::Sub(d.z, d0.z)};
      change = hn::Sub(
          change, hn::Mul(hn::Mul(hn::LoadU(tag, links.gamma + special), inverse_distance), dot(moved, d)));
    }
    if constexpr (weighted || soft)
      change = hn::Mul(change, hn::LoadU(tag, links.factor + special));
    else
      change = hn::Mul(change, plain_factor);
    change = hn::IfThenElseZero(has_direction, change);
    hn::StoreU(hn::Add(multiplier, change), tag, links.multiplier + slot);
    const V shift = hn::Mul(change, inverse_distance);
    if constexpr (weighted) {
      const V move_a = hn::Mul(hn::LoadU(tag, links.move_a + special), shift),
              move_b = hn::Mul(hn::LoadU(tag, links.move_b + special), shift);
      L::store(L::plus(on_a, L::scaled(move_a, between)), position, a + slot);
      L::store(L::minus(on_b, L::scaled(move_b, between)), position, b + slot);
    } else {
      const Rows move = L::scaled(hn::Mul(plain_move, shift), between);
      L::store(L::plus(on_a, move), position, a + slot);
      L::store(L::minus(on_b, move), position, b + slot);
    }
  }
}

template <class Real, bool weighted>
HWY_INLINE void relax_stretch(const LinkArrays<Real>& links, const LinkStretch& stretch,
                              const Packed<Real>* start, Packed<Real>* position) {
  if (stretch.damped)
    relax_present<Real, weighted, true, true>(links, stretch, start, position);
  else if (stretch.soft)
    relax_present<Real, weighted, true, false>(links, stretch, start, position);
  else
    relax_present<Real, weighted, false, false>(links, stretch, start, position);
}

// Masses one by one, whatever the width of vectors.
template <class Real, bool velocities>
HWY_INLINE void move_masses(const FreeMotion<Real>& motion, std::size_t begin, std::size_t end,
                            Packed<Real>* next) {
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
  auto sum = zero;
  for (std::size_t i = begin; i < end; ++i)
    for (std::size_t k = 0; k < 4; k += hn::Lanes(tag))
      sum = hn::Add(sum, hn::Mul(zero, hn::Load(tag, &masses[i].x + k)));  // 0, or not a number for ever
  return hn::AllTrue(tag, hn::Eq(sum, zero));
}

template <class Real>
HWY_INLINE bool relax_stretches(const LinkArrays<Real>& links, std::span<const LinkStretch> stretches,
                                const Packed<Real>* start, const FreeMotion<Real>* motion, std::size_t masses,
                                bool last, Packed<Real>* position) {
  std::size_t begun = 0, done = 0;
  bool good = true;
  const auto begin_until = [&](std::size_t end) HWY_ATTR {
    if (motion != nullptr && end > begun) move_range(*motion, begun, end, position);
    begun = std::max(begun, end);
  };
  const auto end_until = [&](std::size_t end) HWY_ATTR {
    if (last && end > done) good = finite(position, done, end) && good;
    done = std::max(done, end);
  };
  for (const LinkStretch& stretch : stretches) {
    begin_until(stretch.begun);
    stretch.weighted ? relax_stretch<Real, true>(links, stretch, start, position)
                     : relax_stretch<Real, false>(links, stretch, start, position);
    end_until(std::min(stretch.done, begun));
  }
  begin_until(masses);
  end_until(masses);
  return good;
}

bool relax_doubles(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                   const Packed<double>* start, const FreeMotion<double>* motion, std::size_t masses,
                   bool last, Packed<double>* position) {
  return relax_stretches<double>(links, stretches, start, motion, masses, last, position);
}

bool relax_singles(const LinkArrays<float>& links, std::span<const LinkStretch> stretches,
                   const Packed<float>* start, const FreeMotion<float>* motion, std::size_t masses, bool last,
                   Packed<float>* position) {
  return relax_stretches<float>(links, stretches, start, motion, masses, last, position);
}

template <bool weighted, bool judged>
HWY_NOINLINE void relax_along(const LinkArrays<double>& links, const LinkStretch& stretch,
                              const Packed<double>* direction, Packed<double>* position, AlongFound& found) {
  using L = Lanes<double>;
  using Rows = L::Rows;
  const L::Tag tag;
  using V = L::V;
  const V zero = hn::Zero(tag);
  const V plain_move = hn::Set(tag, links.plain_move), plain_factor = hn::Set(tag, links.plain_factor);
  const Index *const a = links.a, *const b = links.b;
  [[maybe_unused]] V worst = zero;
  for (std::size_t slot = stretch.begin; slot < stretch.end; slot += L::count) {
    [[maybe_unused]] const std::size_t special = stretch.special + (slot - stretch.begin);
    const Rows on_a = L::load(position, a + slot), on_b = L::load(position, b + slot);
    const Rows before = L::load_next(direction + slot);
    const Transposed<V> d = L::transposed(L::minus(on_a, on_b)), d0 = L::transposed(before);
    const V length = hn::LoadU(tag, links.length + slot);
    const V square = hn::Mul(length, length), along = dot(d, d0), excess = hn::Sub(dot(d, d), square);
    const auto turned_less = hn::Gt(along, zero);
    if (HWY_UNLIKELY(!hn::AllTrue(tag, turned_less)) && slot < found.lost) {
      double lanes[L::count];
      hn::StoreU(along, tag, lanes);
      for (std::size_t i = L::count; i-- > 0;)
        if (!(lanes[i] > 0.0)) {
          found.lost = slot + i;
          found.lost_along = lanes[i];
        }
    }
    if constexpr (judged) worst = hn::Max(worst, hn::Div(hn::Abs(excess), square));
    V factor = plain_factor;
    if constexpr (weighted) factor = hn::LoadU(tag, links.factor + special);
    const V q = hn::IfThenElseZero(turned_less, hn::Div(hn::Mul(excess, factor), hn::Add(along, along)));
    hn::StoreU(hn::Add(hn::LoadU(tag, links.multiplier + slot), q), tag, links.multiplier + slot);
    if constexpr (weighted) {
      const V move_a = hn::Mul(hn::LoadU(tag, links.move_a + special), q),
              move_b = hn::Mul(hn::LoadU(tag, links.move_b + special), q);
      L::store(L::minus(on_a, L::scaled(move_a, before)), position, a + slot);
      L::store(L::plus(on_b, L::scaled(move_b, before)), position, b + slot);
    } else {
      const Rows move = L::scaled(hn::Mul(plain_move, q), before);
      L::store(L::minus(on_a, move), position, a + slot);
      L::store(L::plus(on_b, move), position, b + slot);
    }
  }
  if constexpr (judged) {
    double lanes[L::count];
    hn::StoreU(worst, tag, lanes);
    for (const double value : lanes)
      if (value > found.worst) found.worst = value;
  }
}

AlongFound relax_all_along(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                           const Packed<double>* direction, bool judged, Packed<double>* position) {
  AlongFound found;
  for (const LinkStretch& stretch : stretches) {
    if (judged)
      stretch.weighted ? relax_along<true, true>(links, stretch, direction, position, found)
                       : relax_along<false, true>(links, stretch, direction, position, found);
    else
      stretch.weighted ? relax_along<true, false>(links, stretch, direction, position, found)
                       : relax_along<false, false>(links, stretch, direction, position, found);
  }
  return found;
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(relax_doubles);
HWY_EXPORT(relax_singles);
HWY_EXPORT(relax_all_along);

template <>
bool relax_along_present(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                         const Packed<double>* start, const FreeMotion<double>* motion, std::size_t masses,
                         bool last, Packed<double>* position) {
  return HWY_DYNAMIC_DISPATCH(relax_doubles)(links, stretches, start, motion, masses, last, position);
}

template <>
bool relax_along_present(const LinkArrays<float>& links, std::span<const LinkStretch> stretches,
                         const Packed<float>* start, const FreeMotion<float>* motion, std::size_t masses,
                         bool last, Packed<float>* position) {
  return HWY_DYNAMIC_DISPATCH(relax_singles)(links, stretches, start, motion, masses, last, position);
}

AlongFound relax_along_start(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                             const Packed<double>* direction, bool judged, Packed<double>* position) {
  return HWY_DYNAMIC_DISPATCH(relax_all_along)(links, stretches, direction, judged, position);
}

void link_directions(const Index* a, const Index* b, std::size_t slots, const Packed<double>* position,
                     Packed<double>* direction) {
  for (std::size_t slot = 0; slot < slots; ++slot) {
    const Packed<double>&on_a = position[a[slot]], &on_b = position[b[slot]];
    direction[slot] = {on_a.x - on_b.x, on_a.y - on_b.y, on_a.z - on_b.z, 0.0};
  }
}

}  // namespace taut

#endif
