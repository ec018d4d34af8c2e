// Sums of stages, made once for every set of vector instructions and chosen by the processor at hand.

#include "high_order/phase_sums.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "high_order/phase_sums.cpp"
// Vectors of unknown size can't be held in a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "high_order/sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

void write_all(const PhaseSums& at, Phase& phase) {
  double* const positions[] = {phase.position.x.data(), phase.position.y.data(), phase.position.z.data()};
  double* const velocities[] = {phase.velocity.x.data(), phase.velocity.y.data(), phase.velocity.z.data()};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for_phases(at, axis, 0, at.masses,
               [&](auto tag, std::size_t i, auto position, auto velocity) TAUT_INLINED {
                 hn::StoreU(position, tag, positions[axis] + i);
                 hn::StoreU(velocity, tag, velocities[axis] + i);
               });
}

LargestSums largest_of_all(const VectorSums& sums, std::size_t masses) {
  // What each lane has met: the largest of both, and 0 unless something is not finite.
  constexpr std::size_t lanes = hn::MaxLanes(Widest());
  HWY_ALIGN double position[lanes] = {}, velocity[lanes] = {}, unsound[lanes] = {};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for_sums(sums, axis, 0, masses,
             [&](auto tag, std::size_t, auto in_position, auto in_velocity) TAUT_INLINED {
               hn::Store(hn::Max(hn::Load(tag, position), hn::Abs(in_position)), tag, position);
               hn::Store(hn::Max(hn::Load(tag, velocity), hn::Abs(in_velocity)), tag, velocity);
               const auto lost = hn::Mul(hn::Zero(tag), hn::Add(in_position, in_velocity));
               hn::Store(hn::Add(hn::Load(tag, unsound), lost), tag, unsound);
             });
  LargestSums largest;
  double lost = 0.0;
  for (std::size_t i = 0; i < lanes; ++i) {
    largest.position = std::max(largest.position, position[i]);
    largest.velocity = std::max(largest.velocity, velocity[i]);
    lost += unsound[i];
  }
  if (lost == 0.0) return largest;
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  return {no_number, no_number};
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(write_all);
HWY_EXPORT(largest_of_all);

void write_phase(const PhaseSums& at, Phase& phase) {
  phase.position.resize(at.masses);
  phase.velocity.resize(at.masses);
  HWY_DYNAMIC_DISPATCH(write_all)(at, phase);
}

LargestSums largest_sums(const VectorSums& sums, std::size_t masses) {
  return HWY_DYNAMIC_DISPATCH(largest_of_all)(sums, masses);
}

}  // namespace taut

#endif
