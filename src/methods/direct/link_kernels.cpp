// Kernels of the direct solves, made once for every set of vector instructions that the compiler can and
// chosen by the processor at hand: one pass over arrays for what takes several when it is written as sums of
// arrays. All give the same bits.

#include "direct/link_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "direct/link_kernels.cpp"
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "each_value-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

// u_a − u_b
template <class D>
HWY_INLINE Three<hn::Vec<D>> across(D tag, const EndsToRead& ends, std::size_t i) {
  return difference(load_three(tag, ends.a, i), load_three(tag, ends.b, i));
}

// What several links, or one, have been found to be.
template <class D>
struct FoundLinks {
  using V = hn::Vec<D>;
  V worst, unsound;  // unsound: 0, or no number
  hn::Mask<D> directed;

  HWY_INLINE explicit FoundLinks(D tag)
      : worst(hn::Zero(tag)), unsound(hn::Zero(tag)), directed(hn::Eq(worst, worst)) {}

  HWY_INLINE void look(D tag, V misfit, V direction) {
    worst = hn::Max(worst, misfit);
    unsound = hn::Add(unsound, hn::Mul(misfit, hn::Zero(tag)));
    directed = hn::And(directed, hn::Gt(direction, hn::Zero(tag)));
  }
  HWY_INLINE Misfit misfit(D tag) const {
    double worsts[hn::MaxLanes(tag)], unsounds[hn::MaxLanes(tag)];
    hn::StoreU(worst, tag, worsts);
    hn::StoreU(unsound, tag, unsounds);
    Misfit all;
    all.directed = hn::AllTrue(tag, directed);
    for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane) {
      all.worst = std::max(all.worst, worsts[lane]);
      all.finite = all.finite && unsounds[lane] == 0.0;
    }
    return all;
  }
};

// Calls measure(tag, found, i) for all of so many links.
template <class Measure>
HWY_INLINE Misfit find_each(std::size_t count, const Measure& measure) {
  const hn::ScalableTag<double> many;
  const hn::CappedTag<double, 1> one;
  FoundLinks<decltype(many)> found_many(many);
  FoundLinks<decltype(one)> found_one(one);
  std::size_t i = 0;
  for (; i + hn::Lanes(many) <= count; i += hn::Lanes(many)) measure(many, found_many, i);
  for (; i < count; ++i) measure(one, found_one, i);
  Misfit all = found_many.misfit(many);
  all.add(found_one.misfit(one));
  return all;
}

void measure_across_of(const EndsToRead& u, const AxesToWrite& difference) {
  for_each_value(0, u.count, [&](auto tag, std::size_t i) TAUT_INLINED {
    store_three(tag, across(tag, u, i), difference, i);
  });
}

Misfit measure_lengths_of(const EndsToRead& position, const AxesToRead& start_direction,
                          const double* squared_length, const double* inverse_square,
                          const AxesToWrite& direction, double* residual) {
  return find_each(position.count, [&](auto tag, auto& found, std::size_t i) TAUT_INLINED {
    const auto d = position.b[0] ? across(tag, position, i) : load_three(tag, position.a, i);
    const auto inverse = hn::LoadU(tag, inverse_square + i);
    const auto misfit =
        hn::Mul(hn::Set(tag, 0.5), hn::Sub(product(d, d), hn::LoadU(tag, squared_length + i)));
    store_three(tag, d, direction, i);
    hn::StoreU(misfit, tag, residual + i);
    found.look(tag, hn::Abs(hn::Mul(misfit, inverse)), product(d, load_three(tag, start_direction, i)));
  });
}

Misfit measure_stretches_of(const EndsToRead& position, const LinkStretches& links) {
  return find_each(position.count, [&](auto tag, auto& found, std::size_t i) TAUT_INLINED {
    const auto d = position.b[0] ? across(tag, position, i) : load_three(tag, position.a, i);
    const auto distance = hn::Sqrt(product(d, d));
    const auto stretch = hn::Sub(distance, hn::LoadU(tag, links.length + i));
    store_three(tag, scaled(hn::Div(hn::Set(tag, 1.0), distance), d), links.direction, i);
    hn::StoreU(distance, tag, links.distance + i);
    hn::StoreU(stretch, tag, links.stretch + i);
    found.look(tag, hn::Mul(hn::Abs(stretch), hn::LoadU(tag, links.inverse_length + i)), distance);
  });
}

void measure_along_of(const EndsToRead& u, const AxesToRead& columns, double* result) {
  for_each_value(0, u.count, [&](auto tag, std::size_t i) TAUT_INLINED {
    hn::StoreU(product(load_three(tag, columns, i), across(tag, u, i)), tag, result + i);
  });
}

void measure_along_moving_of(const EndsToRead& u, const EndsToRead& v, const AxesToRead& columns,
                             double* result) {
  for_each_value(0, u.count, [&](auto tag, std::size_t i) TAUT_INLINED {
    const auto moving = across(tag, v, i);
    hn::StoreU(hn::Add(product(load_three(tag, columns, i), across(tag, u, i)), product(moving, moving)), tag,
               result + i);
  });
}

void measure_along_falling_of(const Falling& falling, const EndsToRead& v, const AxesToRead& columns,
                              double* result) {
  for_each_value(0, v.count, [&](auto tag, std::size_t i) TAUT_INLINED {
    using V = hn::Vec<decltype(tag)>;
    const V one = hn::Set(tag, 1.0), drag = hn::Set(tag, falling.drag);
    const auto fall = [&](const double* inverse_mass, const auto& moving) TAUT_INLINED {
      const auto free = hn::Min(hn::Mul(hn::Set(tag, 1e300), hn::LoadU(tag, inverse_mass + i)), one);
      const auto& g = falling.gravity;
      const Three<V> gravity{hn::Set(tag, g[0]), hn::Set(tag, g[1]), hn::Set(tag, g[2])};
      return scaled(free, difference(gravity, scaled(drag, moving)));
    };
    const auto at_a = load_three(tag, v.a, i), at_b = load_three(tag, v.b, i);
    const auto moving = difference(at_a, at_b);
    const auto falls = difference(fall(falling.inverse_mass_a, at_a), fall(falling.inverse_mass_b, at_b));
    hn::StoreU(hn::Add(product(load_three(tag, columns, i), falls), product(moving, moving)), tag,
               result + i);
  });
}

void push_row_of(const RowPush& push, const AxesToWrite& target, Extent masses) {
  const auto pushed = [&](auto tag, const double* inverse_mass, std::size_t i) TAUT_INLINED {
    const auto size = hn::Mul(hn::Mul(hn::Set(tag, push.factor), hn::LoadU(tag, inverse_mass + i)),
                              hn::LoadU(tag, push.strength + i));
    return scaled(size, load_three(tag, push.columns, i));
  };
  const hn::CappedTag<double, 1> one;
  const bool with_first = masses.begin == 0, with_last = masses.end > push.count;
  if (with_first)
    store_three(one, sum(load_three(one, target, 0), pushed(one, push.inverse_mass_a, 0)), target, 0);
  for_each_value(
      masses.begin + with_first, masses.end - with_last, [&](auto tag, std::size_t i) TAUT_INLINED {
        const auto from_next = sum(load_three(tag, target, i), pushed(tag, push.inverse_mass_a, i));
        store_three(tag, difference(from_next, pushed(tag, push.inverse_mass_b, i - 1)), target, i);
      });
  if (with_last)
    store_three(
        one,
        difference(load_three(one, target, push.count), pushed(one, push.inverse_mass_b, push.count - 1)),
        target, push.count);
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(measure_across_of);
HWY_EXPORT(measure_lengths_of);
HWY_EXPORT(measure_stretches_of);
HWY_EXPORT(measure_along_of);
HWY_EXPORT(measure_along_moving_of);
HWY_EXPORT(measure_along_falling_of);
HWY_EXPORT(push_row_of);

void Misfit::add(const Misfit& other) {
  worst = std::max(worst, other.worst);
  finite = finite && other.finite;
  directed = directed && other.directed;
}

void measure_across(const EndsToRead& u, const AxesToWrite& difference) {
  HWY_DYNAMIC_DISPATCH(measure_across_of)(u, difference);
}

Misfit measure_lengths(const EndsToRead& position, const AxesToRead& start_direction,
                       const double* squared_length, const double* inverse_square,
                       const AxesToWrite& direction, double* residual) {
  return HWY_DYNAMIC_DISPATCH(measure_lengths_of)(position, start_direction, squared_length, inverse_square,
                                                  direction, residual);
}

Misfit measure_stretches(const EndsToRead& position, const LinkStretches& links) {
  return HWY_DYNAMIC_DISPATCH(measure_stretches_of)(position, links);
}

void measure_along(const EndsToRead& u, const AxesToRead& columns, double* result) {
  HWY_DYNAMIC_DISPATCH(measure_along_of)(u, columns, result);
}

void measure_along_moving(const EndsToRead& u, const EndsToRead& v, const AxesToRead& columns,
                          double* result) {
  HWY_DYNAMIC_DISPATCH(measure_along_moving_of)(u, v, columns, result);
}

void measure_along_falling(const Falling& falling, const EndsToRead& v, const AxesToRead& columns,
                           double* result) {
  HWY_DYNAMIC_DISPATCH(measure_along_falling_of)(falling, v, columns, result);
}

void push_row(const RowPush& push, const AxesToWrite& target, Extent masses) {
  HWY_DYNAMIC_DISPATCH(push_row_of)(push, target, masses);
}

}  // namespace taut

#endif
