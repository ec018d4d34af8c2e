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
  const SpreadWeights weights(at.sums);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for_phases(at, weights, axis, 0, at.masses,
               [&](auto tag, std::size_t i, auto position, auto velocity) TAUT_INLINED {
                 hn::StoreU(position, tag, positions[axis] + i);
                 hn::StoreU(velocity, tag, velocities[axis] + i);
               });
}

std::array<LargestSums, 2> write_and_look(const PhaseSums& at, const std::array<VectorSums, 2>& others,
                                          std::size_t begin, std::size_t end, Phase& phase) {
  const AxesToWrite positions = to_write(phase.position), velocities = to_write(phase.velocity);
  const SpreadWeights weights(at.sums), of_first(others[0]), of_second(others[1]);
  LargestMet first_position, first_velocity, second_position, second_velocity;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for_groups(Widest(), begin, end, [&](auto tag, std::size_t i) TAUT_INLINED {
      Sums sums(tag), first(tag), second(tag);
      for (std::size_t j = 0; j < at.sums.count; ++j) {
        const double* values = at.sums.terms[j].axes[axis] + i;
        sums.add(tag, weights, j, values);
        first.add(tag, of_first, j, values);
        second.add(tag, of_second, j, values);
      }
      move_on(tag, at, axis, i, sums.position[0], sums.velocity[0]);
      hn::StoreU(sums.position[0], tag, positions[axis] + i);
      hn::StoreU(sums.velocity[0], tag, velocities[axis] + i);
      first_position.look(tag, hn::Abs(first.position[0]));
      first_velocity.look(tag, hn::Abs(first.velocity[0]));
      second_position.look(tag, hn::Abs(second.position[0]));
      second_velocity.look(tag, hn::Abs(second.velocity[0]));
    });
  return {{{first_position.of_all(), first_velocity.of_all()},
           {second_position.of_all(), second_velocity.of_all()}}};
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(write_all);
HWY_EXPORT(write_and_look);

void write_phase(const PhaseSums& at, Phase& phase) {
  phase.position.resize(at.masses);
  phase.velocity.resize(at.masses);
  HWY_DYNAMIC_DISPATCH(write_all)(at, phase);
}

std::array<LargestSums, 2> write_phase(const PhaseSums& at, const std::array<VectorSums, 2>& others,
                                       Workers* workers, Phase& phase) {
  phase.position.resize(at.masses);
  phase.velocity.resize(at.masses);
  const auto part = [&](std::size_t begin, std::size_t end) {
    return HWY_DYNAMIC_DISPATCH(write_and_look)(at, others, begin, end, phase);
  };
  if (workers == nullptr || at.masses < fewest_to_share_in_halves) return part(0, at.masses);
  std::array<std::array<LargestSums, 2>, 2> of_halves;
  const std::size_t middle = at.masses / 2;
  run_jobs(workers, 2, [&](std::size_t half) {
    of_halves[half] = half == 0 ? part(0, middle) : part(middle, at.masses);
  });
  std::array<LargestSums, 2> largest;
  for (std::size_t i = 0; i < largest.size(); ++i)
    largest[i] = {larger_or_none(of_halves[0][i].position, of_halves[1][i].position),
                  larger_or_none(of_halves[0][i].velocity, of_halves[1][i].velocity)};
  return largest;
}

}  // namespace taut

#endif
