// A pass of shake over the links, as pass-inl.h.

#if defined(TAUT_RELAX_ALONG_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_RELAX_ALONG_INL_H
#undef TAUT_RELAX_ALONG_INL_H
#else
#define TAUT_RELAX_ALONG_INL_H
#endif

#include "relax/pass-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

// Notes those links that have turned by 90° or more.
template <class L>
HWY_NOINLINE void note_lost(typename L::V along, std::size_t slot, AlongFound& found) {
  double lanes[L::count];
  hn::StoreU(along, typename L::Tag(), lanes);
  for (const double value : lanes) {
    if (!(value > 0.0)) found.lost.push_back({slot, value});
    ++slot;
  }
}

template <class L, bool strided, bool alike, bool weighted, bool first, bool judged>
HWY_NOINLINE void relax_along(const LinkArrays<double>& all_links, const LinkStretch& stretch,
                              RoomView<const double> start, RoomView<double> position,
                              [[maybe_unused]] Ahead<L>& ahead, AlongFound& found) {
  using V = typename L::V;
  const typename L::Tag tag;
  const V zero = hn::Zero(tag), half = hn::Set(tag, 0.5), plain_factor = hn::Set(tag, all_links.plain_factor);
  const LinkArrays<double> links = all_links;
  const Ends<double, strided> a(links.a, stretch), b(links.b, stretch);
  [[maybe_unused]] const std::size_t first_slot = stretch.begin;
  [[maybe_unused]] const std::size_t special = stretch.special - stretch.begin;
  [[maybe_unused]] V worst = zero;
  const auto moves_of = [&](std::size_t slot, const Transposed<V>& d0, const Transposed<V>& d) TAUT_INLINED {
    const V length = hn::LoadU(tag, links.length + (alike ? first_slot : slot)),
            square = hn::Mul(length, length);
    V along = dot(d, d0), excess = hn::Sub(dot(d, d), square);
    if constexpr (L::split && strided && !alike) {
      const auto there = hn::Ge(length, zero);
      along = hn::IfThenElse(there, along, square);
      excess = hn::IfThenElseZero(there, excess);
    }
    const auto turned_less = hn::Gt(along, zero);
    if (HWY_UNLIKELY(!hn::AllTrue(tag, turned_less))) note_lost<L>(along, slot, found);
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
    return Moves<L>{hn::Mul(share_a, back), hn::Mul(share_b, back)};
  };
  const auto between = [&](RoomView<const double> masses, std::size_t slot) TAUT_INLINED {
    return L::minus(L::load(masses, a.at(slot)), L::load(masses, b.at(slot)));
  };
  const auto correct = [&](std::size_t slot) TAUT_INLINED {
    return moves_of(slot, L::transposed(between(start, slot)), L::transposed(between(read(position), slot)));
  };
  const auto move = [&](std::size_t slot, const Moves<L>& moves) TAUT_INLINED {
    const auto at_a = a.at(slot), at_b = b.at(slot);
    move_links<L, weighted>(moves, between(start, slot), L::load(read(position), at_a),
                            L::load(read(position), at_b), at_a, at_b, position);
  };
  const auto correct_and_move = [&](std::size_t slot) TAUT_INLINED {
    const auto at_a = a.at(slot), at_b = b.at(slot);
    const auto on_a = L::load(read(position), at_a), on_b = L::load(read(position), at_b);
    const auto d0 = between(start, slot);
    const auto moves = moves_of(slot, L::transposed(d0), L::transposed(L::minus(on_a, on_b)));
    move_links<L, weighted>(moves, d0, on_a, on_b, at_a, at_b, position);
  };
  if constexpr (L::split && strided)
    for (std::size_t slot = stretch.begin; slot < stretch.end; slot += L::count) {
      ahead.go_on(slot / L::count);
      correct_and_move(slot);
    }
  else
    for_each_group(stretch.begin, stretch.end, L::count, correct, move);
  if constexpr (judged) {
    double lanes[L::count];
    hn::StoreU(worst, tag, lanes);
    for (const double value : lanes) found.worst = std::max(found.worst, value);
  }
}

template <class L, bool first, bool judged, class... Where>
HWY_INLINE void relax_stretch_along(const LinkArrays<double>& links, const LinkStretch& stretch,
                                    AlongFound& found, Where&... where) {
  if (stretch.weighted)
    relax_along<L, false, false, true, first, judged>(links, stretch, where..., found);
  else if (stretch.stride == 0)
    relax_along<L, false, false, false, first, judged>(links, stretch, where..., found);
  else if (stretch.alike)
    relax_along<L, true, true, false, first, judged>(links, stretch, where..., found);
  else
    relax_along<L, true, false, false, first, judged>(links, stretch, where..., found);
}

template <class L>
HWY_INLINE bool relax_stretches_along(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                                      RoomView<const double> start, const FreeMotion<double>* motion,
                                      const MassRange& masses, PassPlace place, bool judged,
                                      RoomView<double> position, AlongFound& found) {
  found.worst = 0.0;
  return visit_stretches<L>(
      stretches, motion, masses, place.last, position,
      [&](const LinkStretch& stretch, Ahead<L>& ahead) TAUT_INLINED {
        if (place.first)
          judged ? relax_stretch_along<L, true, true>(links, stretch, found, start, position, ahead)
                 : relax_stretch_along<L, true, false>(links, stretch, found, start, position, ahead);
        else
          judged ? relax_stretch_along<L, false, true>(links, stretch, found, start, position, ahead)
                 : relax_stretch_along<L, false, false>(links, stretch, found, start, position, ahead);
      });
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
