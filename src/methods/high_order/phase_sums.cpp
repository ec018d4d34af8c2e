// Sums of stages, made once for every set of vector instructions and chosen by the processor at hand.

#include "high_order/phase_sums.h"

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
  const AxesToWrite positions = to_write(phase.position), velocities = to_write(phase.velocity);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for_phases(at, axis, 0, at.masses,
               [&](auto tag, std::size_t i, auto position, auto velocity) TAUT_INLINED {
                 hn::StoreU(position, tag, positions[axis] + i);
                 hn::StoreU(velocity, tag, velocities[axis] + i);
               });
}

LargestSums largest_of_all(const VectorSums& sums, std::size_t masses) {
  LargestMet position, velocity;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for_sums(sums, axis, 0, masses,
             [&](auto tag, std::size_t, auto in_position, auto in_velocity) TAUT_INLINED {
               position.look(tag, hn::Abs(in_position));
               velocity.look(tag, hn::Abs(in_velocity));
             });
  return {position.of_all(), velocity.of_all()};
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
