// Links side by side whose masses lie as all x, all y and all z: a vector holds the x of one end of each of
// them as it lies, so that nothing has to be turned round. Masses that don't follow each other are gathered,
// which is slow.

#if defined(TAUT_RELAX_SPLIT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_RELAX_SPLIT_LANES_INL_H
#undef TAUT_RELAX_SPLIT_LANES_INL_H
#else
#define TAUT_RELAX_SPLIT_LANES_INL_H
#endif

#include "relax/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

template <class Number>
struct SplitLanes : TransposedRows<typename Lanes<Number>::V> {
  using Real = Number;
  using Tag = typename Lanes<Real>::Tag;
  using typename TransposedRows<typename Lanes<Number>::V>::V;
  using typename TransposedRows<V>::Rows;
  static constexpr bool split = true;
  static constexpr std::size_t count = Lanes<Real>::count;

  static HWY_INLINE V load_all(const Real* first, const Strided& at) {
    return hn::LoadU(Tag(), at_offset(first, at.first));
  }
  static HWY_INLINE V load_all(const Real* first, const Scattered& at) {
    const hn::RebindToSigned<Tag> offset;
    const hn::Rebind<std::uint32_t, Tag> narrow;
    const auto offsets = hn::LoadU(narrow, at.offset);
    if constexpr (sizeof(Real) == sizeof(std::uint32_t))
      return hn::GatherOffset(Tag(), first, hn::BitCast(offset, offsets));
    else
      return hn::GatherOffset(Tag(), first,
                              hn::BitCast(offset, hn::PromoteTo(hn::RebindToUnsigned<Tag>(), offsets)));
  }
  static HWY_INLINE void store_all(V value, Real* first, const Strided& at) {
    hn::StoreU(value, Tag(), at_offset(first, at.first));
  }
  static HWY_INLINE void store_all(V value, Real* first, const Scattered& at) {
    HWY_ALIGN Real values[count];
    hn::Store(value, Tag(), values);
    for (std::size_t i = 0; i < count; ++i) *at_offset(first, at(i)) = values[i];
  }

  template <class Places>
  static HWY_INLINE Rows load(RoomView<const Real> masses, const Places& at) {
    const Real* x = masses.first;
    return {load_all(x, at), load_all(x + masses.component, at), load_all(x + 2 * masses.component, at)};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, RoomView<Real> masses, const Places& at) {
    Real* x = masses.first;
    store_all(rows.x, x, at);
    store_all(rows.y, x + masses.component, at);
    store_all(rows.z, x + 2 * masses.component, at);
  }
};

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
