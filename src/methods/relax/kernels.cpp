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

// A lambda that is part of the loop it stands in.
#undef TAUT_INLINED
#define TAUT_INLINED HWY_ATTR __attribute__((always_inline))

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The x, y and z of as many links as a vector has lanes.
template <class V>
struct Transposed {
  V x, y, z;
};

// Where the masses of a vector's links lie: anywhere, …
struct Scattered {
  const std::uint32_t* offset;
  HWY_INLINE std::size_t operator()(std::size_t i) const { return offset[i]; }
};
// … or at equal distances.
struct Strided {
  std::size_t first, stride;
  HWY_INLINE std::size_t operator()(std::size_t i) const { return first + i * stride; }
};

template <class Real>
HWY_INLINE Packed<Real>& at_offset(Packed<Real>* masses, std::size_t offset) {
  return *reinterpret_cast<Packed<Real>*>(reinterpret_cast<char*>(masses) + offset);
}
template <class Real>
HWY_INLINE const Packed<Real>& at_offset(const Packed<Real>* masses, std::size_t offset) {
  return *reinterpret_cast<const Packed<Real>*>(reinterpret_cast<const char*>(masses) + offset);
}

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

  template <class Places>
  static HWY_INLINE Rows load(const Packed<Real>* masses, const Places& at) {
    const Packed<Real>& mass = at_offset(masses, at(0));
    return {hn::Load(Tag(), &mass.x), hn::Load(Tag(), &mass.y), hn::Load(Tag(), &mass.z)};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, Packed<Real>* masses, const Places& at) {
    Packed<Real>& mass = at_offset(masses, at(0));
    hn::Store(rows.x, Tag(), &mass.x);
    hn::Store(rows.y, Tag(), &mass.y);
    hn::Store(rows.z, Tag(), &mass.z);
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

  template <class Places>
  static HWY_INLINE Rows load(const Packed<double>* masses, const Places& at) {
    const auto one = [&](std::size_t i) TAUT_INLINED { return hn::Load(Tag(), &at_offset(masses, at(i)).x); };
    return {{one(0), one(1), one(2), one(3)}};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, Packed<double>* masses, const Places& at) {
    for (std::size_t i = 0; i < 4; ++i) hn::Store(rows.link[i], Tag(), &at_offset(masses, at(i)).x);
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

  template <class Places>
  static HWY_INLINE Rows load(const Packed<double>* masses, const Places& at) {
    const Packed<double>&first = at_offset(masses, at(0)), &second = at_offset(masses, at(1));
    return {{hn::Load(Tag(), &first.x), hn::Load(Tag(), &second.x)},
            {hn::Load(Tag(), &first.z), hn::Load(Tag(), &second.z)}};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, Packed<double>* masses, const Places& at) {
    for (std::size_t i = 0; i < 2; ++i) {
      hn::Store(rows.xy[i], Tag(), &at_offset(masses, at(i)).x);
      hn::Store(rows.z[i], Tag(), &at_offset(masses, at(i)).z);
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
  template <class Places>
  static HWY_INLINE Rows load(const Packed<float>* masses, const Places& at) {
    const auto one = [&](std::size_t i) TAUT_INLINED {
      return load_row(at_offset(masses, at(i)), at_offset(masses, at((i + 4) % count)));
    };
    return {{one(0), one(1), one(2), one(3)}};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, Packed<float>* masses, const Places& at) {
    for (std::size_t i = 0; i < 4; ++i) {
#if HWY_MAX_BYTES >= 32
      hn::Store(hn::LowerHalf(rows.link[i]), Mass(), &at_offset(masses, at(i)).x);
      hn::Store(hn::UpperHalf(Mass(), rows.link[i]), Mass(), &at_offset(masses, at(i + 4)).x);
#else
      hn::Store(rows.link[i], Mass(), &at_offset(masses, at(i)).x);
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

template <class Real>
HWY_INLINE bool relax_stretches(const LinkArrays<Real>& links, std::span<const LinkStretch> stretches,
                                const Packed<Real>* start, const FreeMotion<Real>* motion,
                                const MassRange& masses, PassPlace place, Packed<Real>* position) {
  std::size_t begun = masses.begin, done = masses.settled_begin;
  bool good = true;
  const auto begin_until = [&](std::size_t end) TAUT_INLINED {
    if (motion != nullptr && end > begun) move_range(*motion, begun, end, position);
    begun = std::max(begun, end);
  };
  const auto end_until = [&](std::size_t end) TAUT_INLINED {
    if (place.last && end > done) good = finite(position, done, end) && good;
    done = std::max(done, end);
  };
  for (const LinkStretch& stretch : stretches) {
    begin_until(stretch.begun);
    place.first ? relax_stretch<Real, true>(links, stretch, start, position)
                : relax_stretch<Real, false>(links, stretch, start, position);
    end_until(std::min({stretch.done, begun, masses.settled_end}));
  }
  begin_until(masses.end);
  end_until(masses.settled_end);
  return good;
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
HWY_INLINE void relax_each_along(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                                 const Packed<double>* start, Packed<double>* position, AlongFound& found) {
  for (const LinkStretch& stretch : stretches)
    if (stretch.weighted)
      relax_along<false, true, first, judged>(links, stretch, start, position, found);
    else if (stretch.stride == 0)
      relax_along<false, false, first, judged>(links, stretch, start, position, found);
    else
      relax_along<true, false, first, judged>(links, stretch, start, position, found);
}

void relax_all_along(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                     const Packed<double>* start, bool first, bool judged, Packed<double>* position,
                     AlongFound& found) {
  found.worst = 0.0;
  if (first)
    judged ? relax_each_along<true, true>(links, stretches, start, position, found)
           : relax_each_along<true, false>(links, stretches, start, position, found);
  else
    judged ? relax_each_along<false, true>(links, stretches, start, position, found)
           : relax_each_along<false, false>(links, stretches, start, position, found);
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

void relax_along_start(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                       const Packed<double>* start, bool first, bool judged, Packed<double>* position,
                       AlongFound& found) {
  HWY_DYNAMIC_DISPATCH(relax_all_along)(links, stretches, start, first, judged, position, found);
}

}  // namespace taut

#endif
