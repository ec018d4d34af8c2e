// The energy of masses that came where they are in a step, summed in four parts whatever the vectors: the
// same bits from all of them.

#if defined(TAUT_RELAX_ENERGY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_RELAX_ENERGY_INL_H
#undef TAUT_RELAX_ENERGY_INL_H
#else
#define TAUT_RELAX_ENERGY_INL_H
#endif

#include <hwy/highway.h>

#include <span>

#include "relax/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Sums of four numbers at a time.
struct FourSums {
  using Tag = hn::CappedTag<double, 4>;
  using V = hn::Vec<Tag>;
  static constexpr std::size_t lanes = hn::MaxLanes(Tag());

  V part[4 / lanes];

  HWY_INLINE FourSums() {
    for (V& each : part) each = hn::Zero(Tag());
  }
  HWY_INLINE double total() const {
    double sums[4];
    for (std::size_t i = 0; i < 4; i += lanes) hn::StoreU(part[i / lanes], Tag(), sums + i);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }
};

// Of motion and height along axes, of so many masses as a vector has lanes.
HWY_INLINE FourSums::V energy_along(const MotionEnergy& of, FourSums::V mass, FourSums::V now,
                                    FourSums::V before, FourSums::V gain, FourSums::V lift) {
  const FourSums::Tag tag;
  const auto moved =
      hn::Mul(hn::Mul(hn::Sub(now, before), hn::Set(tag, of.inverse_h)), hn::Set(tag, of.keep));
  const auto velocity = hn::Add(moved, gain);
  const auto half_square = hn::Mul(hn::Mul(hn::Set(tag, 0.5), velocity), velocity);
  return hn::Mul(mass, hn::Add(half_square, hn::Mul(lift, now)));
}

HWY_INLINE double energy_of_packed(const MotionEnergy& of, std::span<const double> mass,
                                   RoomView<const double> now, RoomView<const double> before) {
  const FourSums::Tag tag;
  FourSums sums;
  for (std::size_t place = 0; place < mass.size(); ++place)
    for (std::size_t i = 0; i < 4; i += FourSums::lanes) {
      auto& sum = sums.part[i / FourSums::lanes];
      sum =
          hn::Add(sum, energy_along(of, hn::Set(tag, mass[place]), hn::LoadU(tag, now.first + 4 * place + i),
                                    hn::LoadU(tag, before.first + 4 * place + i),
                                    hn::LoadU(tag, &of.gain.x + i), hn::LoadU(tag, &of.lift.x + i)));
    }
  return sums.total();
}

HWY_INLINE double energy_of_split(const MotionEnergy& of, std::span<const double> mass,
                                  RoomView<const double> now, RoomView<const double> before) {
  const FourSums::Tag tag;
  FourSums sums;
  for (std::size_t place = 0; place < mass.size(); place += FourSums::lanes) {
    auto& sum = sums.part[place / FourSums::lanes % (4 / FourSums::lanes)];
    const auto masses = hn::LoadU(tag, mass.data() + place);
    for (std::size_t k = 0; k < 3; ++k)
      sum = hn::Add(sum, energy_along(of, masses, hn::LoadU(tag, now.first + k * now.component + place),
                                      hn::LoadU(tag, before.first + k * before.component + place),
                                      hn::Set(tag, (&of.gain.x)[k]), hn::Set(tag, (&of.lift.x)[k])));
  }
  return sums.total();
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
