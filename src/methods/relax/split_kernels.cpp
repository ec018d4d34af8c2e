// The same kernels as in packed_kernels.cpp, where masses lie as all x, all y and all z.

#include "relax/layout_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relax/split_kernels.cpp"
// Vectors of unknown size can't be held in a struct. With AVX-512 these would be no wider than with AVX2, and
// a tenth slower for its masks.
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_AVX3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "relax/along-inl.h"
#include "relax/split_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

bool relax_split_doubles(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                         RoomView<const double> start, const FreeMotion<double>* motion,
                         const MassRange& masses, PassPlace place, RoomView<double> position) {
  return relax_stretches<SplitLanes<double> >(links, stretches, start, motion, masses, place, position);
}

bool relax_split_singles(const LinkArrays<float>& links, std::span<const LinkStretch> stretches,
                         RoomView<const float> start, const FreeMotion<float>* motion,
                         const MassRange& masses, PassPlace place, RoomView<float> position) {
  return relax_stretches<SplitLanes<float> >(links, stretches, start, motion, masses, place, position);
}

bool relax_split_along(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                       RoomView<const double> start, const FreeMotion<double>* motion,
                       const MassRange& masses, PassPlace place, bool judged, RoomView<double> position,
                       AlongFound& found) {
  return relax_stretches_along<SplitLanes<double> >(links, stretches, start, motion, masses, place, judged,
                                                    position, found);
}

bool split_doubles_are_finite(RoomView<const double> position, std::size_t begin, std::size_t end) {
  return finite<SplitLanes<double> >(position, begin, end);
}

bool split_singles_are_finite(RoomView<const float> position, std::size_t begin, std::size_t end) {
  return finite<SplitLanes<float> >(position, begin, end);
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(relax_split_doubles);
HWY_EXPORT(relax_split_singles);
HWY_EXPORT(relax_split_along);
HWY_EXPORT(split_doubles_are_finite);
HWY_EXPORT(split_singles_are_finite);

LayoutKernels<double> split_double_kernels() {
  return {&HWY_DYNAMIC_DISPATCH(relax_split_doubles), &HWY_DYNAMIC_DISPATCH(split_doubles_are_finite)};
}

LayoutKernels<float> split_single_kernels() {
  return {&HWY_DYNAMIC_DISPATCH(relax_split_singles), &HWY_DYNAMIC_DISPATCH(split_singles_are_finite)};
}

AlongKernel split_along_kernel() {
  return &HWY_DYNAMIC_DISPATCH(relax_split_along);
}

}  // namespace taut

#endif
