// What the kernels do with links side by side, for one set of vector instructions: included once for each.

#if defined(TAUT_RELAX_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_RELAX_LANES_INL_H
#undef TAUT_RELAX_LANES_INL_H
#else
#define TAUT_RELAX_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "inlined.h"
#include "relax/vector_room.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The x, y and z of as many links as a vector has lanes.
template <class V>
struct Transposed {
  V x, y, z;
};

template <class V>
HWY_INLINE V dot(const Transposed<V>& a, const Transposed<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

template <class Real>
HWY_INLINE RoomView<const Real> read(RoomView<Real> masses) {
  return {masses.first, masses.component};
}

// Rows that have that form from the start.
template <class Vector>
struct TransposedRows {
  using V = Vector;
  using Rows = Transposed<V>;

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

template <class Number>
HWY_INLINE Number* at_offset(Number* first, std::size_t bytes) {
  using Byte = std::conditional_t<std::is_const_v<Number>, const char, char>;
  return reinterpret_cast<Number*>(reinterpret_cast<Byte*>(first) + bytes);
}

// Of masses whose four numbers lie side by side.
template <class Number>
struct Lanes;

#if HWY_TARGET == HWY_SCALAR

// One link at a time.
template <class Number>
struct Lanes : TransposedRows<hn::Vec<hn::FixedTag<Number, 1> > > {
  using Real = Number;
  using Tag = hn::FixedTag<Real, 1>;
  using typename TransposedRows<hn::Vec<Tag> >::Rows;
  static constexpr bool split = false;
  static constexpr std::size_t count = 1;

  template <class Places>
  static HWY_INLINE Rows load(RoomView<const Real> masses, const Places& at) {
    const Real* x = at_offset(masses.first, at(0));
    return {hn::Load(Tag(), x), hn::Load(Tag(), x + 1), hn::Load(Tag(), x + 2)};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, RoomView<Real> masses, const Places& at) {
    Real* x = at_offset(masses.first, at(0));
    hn::Store(rows.x, Tag(), x);
    hn::Store(rows.y, Tag(), x + 1);
    hn::Store(rows.z, Tag(), x + 2);
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

// Four vectors, each with a mass of one link or of two.
template <class Vector>
struct FourRows {
  using V = Vector;
  struct Rows {
    V link[4];
  };

  static HWY_INLINE Rows minus(const Rows& a, const Rows& b) {
    return {{hn::Sub(a.link[0], b.link[0]), hn::Sub(a.link[1], b.link[1]), hn::Sub(a.link[2], b.link[2]),
             hn::Sub(a.link[3], b.link[3])}};
  }
  static HWY_INLINE Rows plus(const Rows& a, const Rows& b) {
    return {{hn::Add(a.link[0], b.link[0]), hn::Add(a.link[1], b.link[1]), hn::Add(a.link[2], b.link[2]),
             hn::Add(a.link[3], b.link[3])}};
  }
};

#if HWY_MAX_BYTES >= 32

template <>
struct Lanes<double> : FourRows<hn::Vec<Doubles> > {
  using Real = double;
  using Tag = Doubles;
  static constexpr bool split = false;
  static constexpr std::size_t count = 4;

  template <class Places>
  static HWY_INLINE Rows load(RoomView<const double> masses, const Places& at) {
    const auto one = [&](std::size_t i)
                         TAUT_INLINED { return hn::Load(Tag(), at_offset(masses.first, at(i))); };
    return {{one(0), one(1), one(2), one(3)}};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, RoomView<double> masses, const Places& at) {
    for (std::size_t i = 0; i < 4; ++i) hn::Store(rows.link[i], Tag(), at_offset(masses.first, at(i)));
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
  using Real = double;
  using Tag = Doubles;
  using V = hn::Vec<Tag>;
  struct Rows {
    V xy[2], z[2];  // z and nothing
  };
  static constexpr bool split = false;
  static constexpr std::size_t count = 2;

  template <class Places>
  static HWY_INLINE Rows load(RoomView<const double> masses, const Places& at) {
    const double *first = at_offset(masses.first, at(0)), *second = at_offset(masses.first, at(1));
    return {{hn::Load(Tag(), first), hn::Load(Tag(), second)},
            {hn::Load(Tag(), first + 2), hn::Load(Tag(), second + 2)}};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, RoomView<double> masses, const Places& at) {
    for (std::size_t i = 0; i < 2; ++i) {
      double* x = at_offset(masses.first, at(i));
      hn::Store(rows.xy[i], Tag(), x);
      hn::Store(rows.z[i], Tag(), x + 2);
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

// A row is of a link and, where vectors are wide, of the one four places on.
template <>
struct Lanes<float> : FourRows<hn::Vec<Singles> > {
  using Real = float;
  using Tag = Singles;
  using Mass = hn::FixedTag<float, 4>;
  using Pairs = hn::RepartitionToWide<Tag>;
  static constexpr bool split = false;
  static constexpr std::size_t count = hn::MaxLanes(Tag());

  static HWY_INLINE V load_row(const float* low, [[maybe_unused]] const float* high) {
#if HWY_MAX_BYTES >= 32
    return hn::Combine(Tag(), hn::Load(Mass(), high), hn::Load(Mass(), low));
#else
    return hn::Load(Mass(), low);
#endif
  }
  template <class Places>
  static HWY_INLINE Rows load(RoomView<const float> masses, const Places& at) {
    const auto one = [&](std::size_t i) TAUT_INLINED {
      return load_row(at_offset(masses.first, at(i)), at_offset(masses.first, at((i + 4) % count)));
    };
    return {{one(0), one(1), one(2), one(3)}};
  }
  template <class Places>
  static HWY_INLINE void store(const Rows& rows, RoomView<float> masses, const Places& at) {
    for (std::size_t i = 0; i < 4; ++i) {
#if HWY_MAX_BYTES >= 32
      hn::Store(hn::LowerHalf(rows.link[i]), Mass(), at_offset(masses.first, at(i)));
      hn::Store(hn::UpperHalf(Mass(), rows.link[i]), Mass(), at_offset(masses.first, at(i + 4)));
#else
      hn::Store(rows.link[i], Mass(), at_offset(masses.first, at(i)));
#endif
    }
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

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
