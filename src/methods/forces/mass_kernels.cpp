// Kernels that go over masses, made once for every set of vector instructions that the compiler can and
// chosen by the processor at hand. All give the same bits.

#include "forces/mass_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/mass_kernels.cpp"
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "each_value-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

// 1 for free masses and 0 for pins.
template <class D>
HWY_INLINE hn::Vec<D> free_share(D tag, const double* inverse_mass) {
  return hn::Min(hn::Mul(hn::Set(tag, 1e300), hn::LoadU(tag, inverse_mass)), hn::Set(tag, 1.0));
}

// Velocities after the kick: v (keep f + (1 − f)) + gain f with f 1 for free masses and 0 for pins, so
// without branches.
template <class D, class V>
HWY_INLINE Three<V> kicked_by(D tag, const MassKick& kick, std::size_t i, const Three<V>& v) {
  const V one = hn::Set(tag, 1.0), free = free_share(tag, kick.inverse_mass + i);
  const V keep = hn::Add(hn::Mul(hn::Set(tag, kick.keep), free), hn::Sub(one, free));
  const Three<V> gain{hn::Set(tag, kick.gain[0]), hn::Set(tag, kick.gain[1]), hn::Set(tag, kick.gain[2])};
  return sum(scaled(keep, v), scaled(free, gain));
}

void kick_each(std::size_t count, const MassKick& kick, const AxesToRead& velocity,
               const AxesToWrite& kicked) {
  for_each_value(0, count, [&](auto tag, std::size_t i) TAUT_INLINED {
    store_three(tag, kicked_by(tag, kick, i, load_three(tag, velocity, i)), kicked, i);
  });
}

void kick_and_move_each(std::size_t count, const MassKick& kick, double h, const AxesToRead& position,
                        const AxesToRead& velocity, const AxesToWrite& kicked, const AxesToWrite& moved) {
  for_each_value(0, count, [&](auto tag, std::size_t i) TAUT_INLINED {
    const auto v = kicked_by(tag, kick, i, load_three(tag, velocity, i));
    if (kicked[0]) store_three(tag, v, kicked, i);
    store_three(tag, sum(load_three(tag, position, i), scaled(hn::Set(tag, h), v)), moved, i);
  });
}

void mean_each(std::size_t count, double rate, const AxesToRead& from, const AxesToRead& to,
               const AxesToWrite& velocity) {
  for_each_value(0, count, [&](auto tag, std::size_t i) TAUT_INLINED {
    const auto moved = difference(load_three(tag, to, i), load_three(tag, from, i));
    store_three(tag, scaled(hn::Set(tag, rate), moved), velocity, i);
  });
}

void mean_and_kick_each(std::size_t count, const MassKick& kick, double rate, const AxesToRead& from,
                        const AxesToRead& to, const AxesToWrite& velocity) {
  for_each_value(0, count, [&](auto tag, std::size_t i) TAUT_INLINED {
    const auto moved = difference(load_three(tag, to, i), load_three(tag, from, i));
    store_three(tag, kicked_by(tag, kick, i, scaled(hn::Set(tag, rate), moved)), velocity, i);
  });
}

double energy_of_each(std::size_t count, const FallingMasses& masses, const AxesToRead& position,
                      const AxesToRead& velocity) {
  const auto energy = [&](auto tag, std::size_t i) TAUT_INLINED {
    const auto& g = masses.gravity;
    const Three<hn::Vec<decltype(tag)>> gravity{hn::Set(tag, g[0]), hn::Set(tag, g[1]), hn::Set(tag, g[2])};
    const auto v = load_three(tag, velocity, i);
    const auto mass = hn::Mul(free_share(tag, masses.inverse_mass + i), hn::LoadU(tag, masses.mass + i));
    const auto each =
        hn::Sub(hn::Mul(hn::Set(tag, 0.5), product(v, v)), product(gravity, load_three(tag, position, i)));
    return hn::Mul(mass, each);
  };
  // As many sums side by side, whatever the vectors' width, so that it changes no bit.
  constexpr std::size_t sums = 8;
  const hn::CappedTag<double, sums> many;
  const hn::CappedTag<double, 1> one;
  const std::size_t lanes = hn::Lanes(many);
  HWY_ALIGN double all[sums] = {};
  std::size_t i = 0;
  for (; i + sums <= count; i += sums)
    for (std::size_t lane = 0; lane < sums; lane += lanes)
      hn::Store(hn::Add(hn::Load(many, all + lane), energy(many, i + lane)), many, all + lane);
  double sum = 0.0;
  for (const double each : all) sum += each;
  for (; i < count; ++i) sum += hn::GetLane(energy(one, i));
  return sum;
}

double largest_of_each(std::size_t count, const AxesToRead& vectors) {
  double largest = 0.0;
  const auto look = [&](auto tag, std::size_t i, auto before) TAUT_INLINED {
    const auto [x, y, z] = load_three(tag, vectors, i);
    return hn::Max(hn::Max(hn::Abs(x), hn::Abs(y)), hn::Max(hn::Abs(z), before));
  };
  const hn::ScalableTag<double> many;
  auto of_many = hn::Zero(many);
  std::size_t i = 0;
  for (; i + hn::Lanes(many) <= count; i += hn::Lanes(many)) of_many = look(many, i, of_many);
  largest = hn::GetLane(hn::MaxOfLanes(many, of_many));
  const hn::CappedTag<double, 1> one;
  for (; i < count; ++i) largest = hn::GetLane(look(one, i, hn::Set(one, largest)));
  return largest;
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(kick_each);
HWY_EXPORT(kick_and_move_each);
HWY_EXPORT(mean_each);
HWY_EXPORT(mean_and_kick_each);
HWY_EXPORT(energy_of_each);
HWY_EXPORT(largest_of_each);

void kick_masses(std::size_t count, const MassKick& kick, const AxesToRead& velocity,
                 const AxesToWrite& kicked) {
  HWY_DYNAMIC_DISPATCH(kick_each)(count, kick, velocity, kicked);
}

void kick_and_move(std::size_t count, const MassKick& kick, double h, const AxesToRead& position,
                   const AxesToRead& velocity, const AxesToWrite& kicked, const AxesToWrite& moved) {
  HWY_DYNAMIC_DISPATCH(kick_and_move_each)(count, kick, h, position, velocity, kicked, moved);
}

void mean_velocities(std::size_t count, double rate, const AxesToRead& from, const AxesToRead& to,
                     const AxesToWrite& velocity) {
  HWY_DYNAMIC_DISPATCH(mean_each)(count, rate, from, to, velocity);
}

void mean_and_kick(std::size_t count, const MassKick& kick, double rate, const AxesToRead& from,
                   const AxesToRead& to, const AxesToWrite& velocity) {
  HWY_DYNAMIC_DISPATCH(mean_and_kick_each)(count, kick, rate, from, to, velocity);
}

double energy_of_falling(std::size_t count, const FallingMasses& masses, const AxesToRead& position,
                         const AxesToRead& velocity) {
  return HWY_DYNAMIC_DISPATCH(energy_of_each)(count, masses, position, velocity);
}

double largest_of(std::size_t count, const AxesToRead& vectors) {
  return HWY_DYNAMIC_DISPATCH(largest_of_each)(count, vectors);
}

}  // namespace taut

#endif
