// Kernels of the relaxation where masses lie as four numbers side by side, made once for every set of vector
// instructions that the compiler can and chosen by the processor at hand.
//
// Masses of four links (or eight, in single precision) are loaded one by one, subtracted, and only the
// differences transposed, so that a vector holds the x of all links; what each link then moves its masses by
// is spread over its difference again. So there is nothing to be gathered or scattered, and the order of
// links does not matter but for the cache.

#include "relax/layout_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relax/packed_kernels.cpp"
// Vectors of unknown size can't be held in a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "relax/along-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

bool relax_packed_doubles(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                          RoomView<const double> start, const FreeMotion<double>* motion,
                          const MassRange& masses, PassPlace place, RoomView<double> position) {
  return relax_stretches<Lanes<double> >(links, stretches, start, motion, masses, place, position);
}

bool relax_packed_singles(const LinkArrays<float>& links, std::span<const LinkStretch> stretches,
                          RoomView<const float> start, const FreeMotion<float>* motion,
                          const MassRange& masses, PassPlace place, RoomView<float> position) {
  return relax_stretches<Lanes<float> >(links, stretches, start, motion, masses, place, position);
}

bool relax_packed_along(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                        RoomView<const double> start, const FreeMotion<double>* motion,
                        const MassRange& masses, PassPlace place, bool judged, RoomView<double> position,
                        AlongFound& found) {
  return relax_stretches_along<Lanes<double> >(links, stretches, start, motion, masses, place, judged,
                                               position, found);
}

bool packed_doubles_are_finite(RoomView<const double> position, std::size_t begin, std::size_t end) {
  return finite<Lanes<double> >(position, begin, end);
}

bool packed_singles_are_finite(RoomView<const float> position, std::size_t begin, std::size_t end) {
  return finite<Lanes<float> >(position, begin, end);
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(relax_packed_doubles);
HWY_EXPORT(relax_packed_singles);
HWY_EXPORT(relax_packed_along);
HWY_EXPORT(packed_doubles_are_finite);
HWY_EXPORT(packed_singles_are_finite);

LayoutKernels<double> packed_double_kernels() {
  return {&HWY_DYNAMIC_DISPATCH(relax_packed_doubles), &HWY_DYNAMIC_DISPATCH(packed_doubles_are_finite)};
}

LayoutKernels<float> packed_single_kernels() {
  return {&HWY_DYNAMIC_DISPATCH(relax_packed_singles), &HWY_DYNAMIC_DISPATCH(packed_singles_are_finite)};
}

AlongKernel packed_along_kernel() {
  return &HWY_DYNAMIC_DISPATCH(relax_packed_along);
}

}  // namespace taut

#endif
