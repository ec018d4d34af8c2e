// A pass over the links, for one set of vector instructions and one way in which masses lie (L: Lanes or
// SplitLanes): included once for each. All of them give the same bits: each link's numbers stay in a lane of
// their own, root and division are exact, and a product and a sum are never one operation.

#if defined(TAUT_RELAX_PASS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_RELAX_PASS_INL_H
#undef TAUT_RELAX_PASS_INL_H
#else
#define TAUT_RELAX_PASS_INL_H
#endif

#include <algorithm>

#include "relax/kernels.h"
#include "relax/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

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
template <class L>
struct Moves {
  typename L::V a, b;
};

// The free motion of as many numbers as a vector has, from the one at `number` on.
template <bool velocities, class Tag, class Real = hn::TFromD<Tag>, class V = hn::Vec<Tag> >
HWY_INLINE void move_numbers(Tag tag, const FreeMotion<Real>& motion, std::size_t number, V end_gain, V gain,
                             Real* next) {
  const V at = hn::LoadU(tag, motion.present.first + number);
  V velocity = hn::LoadU(tag, motion.previous.first + number);
  if constexpr (!velocities) {
    velocity = hn::Mul(hn::Sub(at, velocity), hn::Set(tag, motion.inverse_h));
    velocity = hn::Add(hn::Mul(velocity, hn::Set(tag, motion.end_keep)), end_gain);
  }
  velocity = hn::Add(hn::Mul(velocity, hn::Set(tag, motion.keep)), gain);
  hn::StoreU(hn::Add(at, hn::Mul(hn::Set(tag, motion.h), velocity)), tag, next + number);
}

// The free motion of masses that no link has come to yet, a few at a time between groups of links: so a
// processor has something to do while it waits for roots and quotients, and need not wait for memory later.
template <class L>
struct Ahead {
  using Real = typename L::Real;
  const FreeMotion<Real>* motion = nullptr;
  RoomView<Real> next{};
  std::size_t begun = 0, end = 0;  // the first mass that has not moved, and where to stop

  // As many as a vector has lanes, with every fourth group: a mass for each four links, as sheets with
  // diagonals have them.
  HWY_INLINE void go_on(std::size_t group) {
    if (group % 4 != 0 || begun + L::count > end) return;
    const typename L::Tag tag;
    for (std::size_t k = 0; k < 3; ++k)
      move_numbers<false>(tag, *motion, k * next.component + begun, hn::Set(tag, (&motion->end_gain.x)[k]),
                          hn::Set(tag, (&motion->gain.x)[k]), next.first);
    if (begun % (line / sizeof(Real)) < L::count)
      fetch(std::min(end - 1, begun + lines_ahead * line / sizeof(Real)));
    begun += L::count;
  }

 private:
  static constexpr std::size_t line = 64;  // bytes that a cache takes at once
  static constexpr std::size_t lines_ahead = 32;

  HWY_INLINE void fetch(std::size_t mass) const {
    for (const Real* room : {motion->previous.first, motion->present.first, read(next).first})
      for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(room + k * next.component + mass, 0, 2);
  }
};

// Moves masses of links along these rows: a's, from on_a, that way, and b's the other.
template <class L, bool weighted, class Places>
HWY_INLINE void move_links(const Moves<L>& moves, const typename L::Rows& along, const typename L::Rows& on_a,
                           const typename L::Rows& on_b, const Places& at_a, const Places& at_b,
                           RoomView<typename L::Real> position) {
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

template <class L, bool strided, bool alike, bool weighted, bool soft, bool damped, bool first, bool keeps>
HWY_NOINLINE void relax_present(const LinkArrays<typename L::Real>& all_links, const LinkStretch& stretch,
                                [[maybe_unused]] RoomView<const typename L::Real> start,
                                RoomView<typename L::Real> position, [[maybe_unused]] Ahead<L>& ahead) {
  using Real = typename L::Real;
  using V = typename L::V;
  const typename L::Tag tag;
  const V one = hn::Set(tag, Real(1)), zero = hn::Zero(tag);
  [[maybe_unused]] const V half = hn::Set(tag, Real(0.5)),
                           plain_factor = hn::Set(tag, all_links.plain_factor);
  const LinkArrays<Real> links = all_links;  // which no store can change
  const Ends<Real, strided> a(links.a, stretch), b(links.b, stretch);
  [[maybe_unused]] const std::size_t first_slot = stretch.begin;
  [[maybe_unused]] const std::size_t special = stretch.special - stretch.begin;
  const auto moves_of = [&](std::size_t slot, const Transposed<V>& d) TAUT_INLINED {
    const V length = hn::LoadU(tag, links.length + (alike ? first_slot : slot)),
            distance = hn::Sqrt(dot(d, d));
    auto has_direction = hn::Gt(distance, zero);
    if constexpr (L::split && strided && !alike) has_direction = hn::And(has_direction, hn::Ge(length, zero));
    const V inverse_distance = hn::Div(one, distance);
    V over = hn::Sub(length, distance);
    [[maybe_unused]] V multiplier = zero;
    if constexpr (!first) multiplier = hn::LoadU(tag, links.multiplier + slot);
    if constexpr (soft && !first)
      over = hn::Sub(over, hn::Mul(hn::LoadU(tag, links.scaled + (special + slot)), multiplier));
    if constexpr (damped) {
      const Transposed<V> d0 =
          L::transposed(L::minus(L::load(start, a.at(slot)), L::load(start, b.at(slot))));
      const Transposed<V> moved{hn::Sub(d.x, d0.x), hn::Sub(d.y, d0.y), hn::Sub(d.z, d0.z)};
      over = hn::Sub(over, hn::Mul(hn::Mul(hn::LoadU(tag, links.gamma + (special + slot)), inverse_distance),
                                   dot(moved, d)));
    }
    V factor = plain_factor;
    if constexpr (weighted || soft) factor = hn::LoadU(tag, links.factor + (special + slot));
    // Asked for last, so that no quotient waits for it.
    V change = hn::IfThenElseZero(has_direction, hn::Mul(over, factor));
    if constexpr (!first) change = hn::Add(multiplier, change);
    if constexpr (keeps) hn::StoreU(change, tag, links.multiplier + slot);
    const V shift = hn::IfThenElseZero(has_direction, hn::Mul(over, inverse_distance));
    V share_a = half, share_b = half;
    if constexpr (weighted || soft) share_a = hn::LoadU(tag, links.share_a + (special + slot));
    if constexpr (weighted) share_b = hn::LoadU(tag, links.share_b + (special + slot));
    return Moves<L>{hn::Mul(share_a, shift), hn::Mul(share_b, shift)};
  };
  const auto between = [&](std::size_t slot) TAUT_INLINED {
    return L::minus(L::load(read(position), a.at(slot)), L::load(read(position), b.at(slot)));
  };
  const auto correct = [&](std::size_t slot)
                           TAUT_INLINED { return moves_of(slot, L::transposed(between(slot))); };
  const auto move = [&](std::size_t slot, const Moves<L>& moves) TAUT_INLINED {
    const auto at_a = a.at(slot), at_b = b.at(slot);
    const auto on_a = L::load(read(position), at_a), on_b = L::load(read(position), at_b);
    move_links<L, weighted>(moves, L::minus(on_a, on_b), on_a, on_b, at_a, at_b, position);
  };
  const auto correct_and_move = [&](std::size_t slot) TAUT_INLINED {
    const auto at_a = a.at(slot), at_b = b.at(slot);
    const auto on_a = L::load(read(position), at_a), on_b = L::load(read(position), at_b);
    const auto d = L::minus(on_a, on_b);
    move_links<L, weighted>(moves_of(slot, L::transposed(d)), d, on_a, on_b, at_a, at_b, position);
  };
  // Those of a sheet without damping wait so briefly that loading their masses twice costs more.
  if constexpr (L::split && strided && !damped)
    for (std::size_t slot = stretch.begin; slot < stretch.end; slot += L::count) {
      ahead.go_on(slot / L::count);
      correct_and_move(slot);
    }
  else
    for_each_group(stretch.begin, stretch.end, L::count, correct, move);
}

template <class L, bool strided, bool weighted, bool first, bool keeps, class... Where>
HWY_INLINE void relax_soft_or_not(const LinkArrays<typename L::Real>& links, const LinkStretch& stretch,
                                  Where&... where) {
  if (stretch.damped)
    relax_present<L, strided, false, weighted, true, true, first, keeps>(links, stretch, where...);
  else if (stretch.soft)
    relax_present<L, strided, false, weighted, true, false, first, keeps>(links, stretch, where...);
  else
    relax_present<L, strided, false, weighted, false, false, first, keeps>(links, stretch, where...);
}

template <class L, bool first, bool keeps, class... Where>
HWY_INLINE void relax_stretch(const LinkArrays<typename L::Real>& links, const LinkStretch& stretch,
                              Where&... where) {
  if (stretch.weighted)
    relax_soft_or_not<L, false, true, first, keeps>(links, stretch, where...);
  else if (stretch.stride == 0)
    relax_soft_or_not<L, false, false, first, keeps>(links, stretch, where...);
  else if (stretch.alike)
    relax_present<L, true, true, false, false, false, first, keeps>(links, stretch, where...);
  else
    relax_soft_or_not<L, true, false, first, keeps>(links, stretch, where...);
}

template <class Real, bool velocities>
HWY_INLINE void move_packed(const FreeMotion<Real>& free_motion, std::size_t begin, std::size_t end,
                            RoomView<Real> next) {
  const FreeMotion<Real> motion = free_motion;  // which no store can change
  const hn::CappedTag<Real, 4> tag;
  for (std::size_t i = begin; i < end; ++i)
    for (std::size_t k = 0; k < 4; k += hn::Lanes(tag))
      move_numbers<velocities>(tag, motion, 4 * i + k, hn::LoadU(tag, &motion.end_gain.x + k),
                               hn::LoadU(tag, &motion.gain.x + k), next.first);
}

template <class Real, bool velocities>
HWY_INLINE void move_split(const FreeMotion<Real>& free_motion, std::size_t begin, std::size_t end,
                           RoomView<Real> next) {
  const FreeMotion<Real> motion = free_motion;
  const auto move_component = [&](std::size_t before, Real end_gain, Real gain) TAUT_INLINED {
    std::size_t number = before + begin;
    const auto move_by = [&](auto tag) TAUT_INLINED {
      for (; number + hn::Lanes(tag) <= before + end; number += hn::Lanes(tag))
        move_numbers<velocities>(tag, motion, number, hn::Set(tag, end_gain), hn::Set(tag, gain), next.first);
    };
    move_by(typename Lanes<Real>::Tag());
    move_by(hn::FixedTag<Real, 1>());
  };
  move_component(0, motion.end_gain.x, motion.gain.x);
  move_component(next.component, motion.end_gain.y, motion.gain.y);
  move_component(2 * next.component, motion.end_gain.z, motion.gain.z);
}

template <class L, class Real>
HWY_INLINE void move_range(const FreeMotion<Real>& motion, std::size_t begin, std::size_t end,
                           RoomView<Real> next) {
  if constexpr (L::split)
    motion.velocities ? move_split<Real, true>(motion, begin, end, next)
                      : move_split<Real, false>(motion, begin, end, next);
  else
    motion.velocities ? move_packed<Real, true>(motion, begin, end, next)
                      : move_packed<Real, false>(motion, begin, end, next);
}

// Whether the numbers [begin, end) are.
template <class Real>
HWY_INLINE bool numbers_are_finite(const Real* numbers, std::size_t begin, std::size_t end) {
  std::size_t i = begin;
  const auto are_finite_by = [&](auto tag) TAUT_INLINED {
    const auto zero = hn::Zero(tag);
    auto good = hn::Eq(zero, zero);
    for (; i + hn::Lanes(tag) <= end; i += hn::Lanes(tag)) {
      const auto value = hn::LoadU(tag, numbers + i);
      good = hn::And(good, hn::Eq(hn::Sub(value, value), zero));
    }
    return hn::AllTrue(tag, good);
  };
  const bool most = are_finite_by(typename Lanes<Real>::Tag());
  return are_finite_by(hn::FixedTag<Real, 1>()) && most;
}

template <class L, class Real = typename L::Real>
HWY_INLINE bool finite(RoomView<const Real> masses, std::size_t begin, std::size_t end) {
  if constexpr (L::split) {
    bool good = true;
    for (std::size_t k = 0; k < 3; ++k)
      good = numbers_are_finite(masses.first + k * masses.component, begin, end) && good;
    return good;
  } else {
    return numbers_are_finite(masses.first, 4 * begin, 4 * end);
  }
}

// Calls relax(stretch, ahead) for each, with masses moved just ahead of the first link and looked at after
// the last.
template <class L, class Real, class Relax>
HWY_INLINE bool visit_stretches(std::span<const LinkStretch> stretches, const FreeMotion<Real>* motion,
                                const MassRange& masses, bool last, RoomView<Real> position,
                                const Relax& relax) {
  constexpr std::size_t farthest = 2048;  // masses ahead, which are still in a cache when links come to them
  Ahead<L> ahead{motion, position, masses.begin, 0};
  std::size_t done = masses.settled_begin;
  bool good = true;
  const auto begin_until = [&](std::size_t end) TAUT_INLINED {
    if (motion != nullptr && end > ahead.begun) move_range<L>(*motion, ahead.begun, end, position);
    ahead.begun = std::max(ahead.begun, end);
  };
  const auto end_until = [&](std::size_t end) TAUT_INLINED {
    if (last && end > done) good = finite<L>(read(position), done, end) && good;
    done = std::max(done, end);
  };
  for (const LinkStretch& stretch : stretches) {
    begin_until(stretch.begun);
    if (L::split && motion != nullptr && !motion->velocities)
      ahead.end = std::min(masses.end, stretch.begun + farthest);
    relax(stretch, ahead);
    end_until(std::min({stretch.done, stretch.begun, masses.settled_end}));
  }
  begin_until(masses.end);
  end_until(masses.settled_end);
  return good;
}

template <class L, class Real>
HWY_INLINE bool relax_stretches(const LinkArrays<Real>& links, std::span<const LinkStretch> stretches,
                                RoomView<const Real> start, const FreeMotion<Real>* motion,
                                const MassRange& masses, PassPlace place, RoomView<Real> position) {
  return visit_stretches<L>(stretches, motion, masses, place.last, position,
                            [&](const LinkStretch& stretch, Ahead<L>& ahead) TAUT_INLINED {
                              if (!place.first)
                                relax_stretch<L, false, true>(links, stretch, start, position, ahead);
                              else if (place.keeps)
                                relax_stretch<L, true, true>(links, stretch, start, position, ahead);
                              else
                                relax_stretch<L, true, false>(links, stretch, start, position, ahead);
                            });
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
