// Loops over arrays of doubles, several at once, for one set of vector instructions: included once for each.

#if defined(TAUT_EACH_VALUE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_EACH_VALUE_INL_H
#undef TAUT_EACH_VALUE_INL_H
#else
#define TAUT_EACH_VALUE_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>

#include "axes.h"
#include "inlined.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Calls body(tag, i) for the values [i, i + lanes of the tag), until all of [begin, end) have been. A value's
// numbers stay in a lane of their own, so that the width changes no bit.
template <class Body>
HWY_INLINE void for_each_value(std::size_t begin, std::size_t end, const Body& body) {
  const hn::ScalableTag<double> many;
  const hn::CappedTag<double, 1> one;
  std::size_t i = begin;
  for (; i + hn::Lanes(many) <= end; i += hn::Lanes(many)) body(many, i);
  for (; i < end; ++i) body(one, i);
}

// x, y and z of several vectors.
template <class V>
struct Three {
  V x, y, z;
};

template <class D, class Number>
HWY_INLINE Three<hn::Vec<D>> load_three(D tag, const std::array<Number*, 3>& from, std::size_t i) {
  return {hn::LoadU(tag, from[0] + i), hn::LoadU(tag, from[1] + i), hn::LoadU(tag, from[2] + i)};
}
template <class D, class V>
HWY_INLINE void store_three(D tag, const Three<V>& values, const AxesToWrite& to, std::size_t i) {
  hn::StoreU(values.x, tag, to[0] + i);
  hn::StoreU(values.y, tag, to[1] + i);
  hn::StoreU(values.z, tag, to[2] + i);
}
template <class V>
HWY_INLINE Three<V> difference(const Three<V>& a, const Three<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class V>
HWY_INLINE Three<V> sum(const Three<V>& a, const Three<V>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class V>
HWY_INLINE Three<V> scaled(V factor, const Three<V>& a) {
  return {hn::Mul(factor, a.x), hn::Mul(factor, a.y), hn::Mul(factor, a.z)};
}
template <class V>
HWY_INLINE V product(const Three<V>& a, const Three<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
