// Kernels of the relaxation, made once for every set of vector instructions that the compiler can and chosen
// by the processor at hand.
//
// Where masses lie as four numbers side by side, those of four links (or eight, in single precision) are
// loaded one by one, subtracted, and only the differences transposed, so that a vector holds the x of all
// links; what each link then moves its masses by is spread over its difference again. So there is nothing to
// be gathered or scattered, and the order of links does not matter but for the cache. Where they lie as all
// x, all y and all z, and those of links beside each other, nothing has to be transposed either.

#include "relax/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relax/kernels.cpp"
// Vectors of unknown size can't be held in a struct. With AVX-512 these would be no wider than with AVX2, and
// those of sheets a tenth slower for its masks.
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_AVX3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "relax/along-inl.h"
#include "relax/energy-inl.h"
#include "relax/split_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

bool relax_doubles(Layout layout, const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                   RoomView<const double> start, const FreeMotion<double>* motion, const MassRange& masses,
                   PassPlace place, RoomView<double> position) {
  return layout == Layout::split
             ? relax_stretches<SplitLanes<double> >(links, stretches, start, motion, masses, place, position)
             : relax_stretches<Lanes<double> >(links, stretches, start, motion, masses, place, position);
}

bool relax_singles(Layout layout, const LinkArrays<float>& links, std::span<const LinkStretch> stretches,
                   RoomView<const float> start, const FreeMotion<float>* motion, const MassRange& masses,
                   PassPlace place, RoomView<float> position) {
  return layout == Layout::split
             ? relax_stretches<SplitLanes<float> >(links, stretches, start, motion, masses, place, position)
             : relax_stretches<Lanes<float> >(links, stretches, start, motion, masses, place, position);
}

bool relax_all_along(Layout layout, const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                     RoomView<const double> start, const FreeMotion<double>* motion, const MassRange& masses,
                     PassPlace place, bool judged, RoomView<double> position, AlongFound& found) {
  return layout == Layout::split
             ? relax_stretches_along<SplitLanes<double> >(links, stretches, start, motion, masses, place,
                                                          judged, position, found)
             : relax_stretches_along<Lanes<double> >(links, stretches, start, motion, masses, place, judged,
                                                     position, found);
}

bool finite_doubles(Layout layout, RoomView<const double> position, std::size_t begin, std::size_t end) {
  return layout == Layout::split ? finite<SplitLanes<double> >(position, begin, end)
                                 : finite<Lanes<double> >(position, begin, end);
}

bool finite_singles(Layout layout, RoomView<const float> position, std::size_t begin, std::size_t end) {
  return layout == Layout::split ? finite<SplitLanes<float> >(position, begin, end)
                                 : finite<Lanes<float> >(position, begin, end);
}

double energy_of_masses_moved(Layout layout, const MotionEnergy& of, std::span<const double> mass,
                              RoomView<const double> now, RoomView<const double> before) {
  return layout == Layout::split ? energy_of_split(of, mass, now, before)
                                 : energy_of_packed(of, mass, now, before);
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(relax_doubles);
HWY_EXPORT(relax_singles);
HWY_EXPORT(relax_all_along);
HWY_EXPORT(finite_doubles);
HWY_EXPORT(finite_singles);
HWY_EXPORT(energy_of_masses_moved);

template <>
bool relax_along_present(Layout layout, const LinkArrays<double>& links,
                         std::span<const LinkStretch> stretches, RoomView<const double> start,
                         const FreeMotion<double>* motion, const MassRange& masses, PassPlace place,
                         RoomView<double> position) {
  return HWY_DYNAMIC_DISPATCH(relax_doubles)(layout, links, stretches, start, motion, masses, place,
                                             position);
}

template <>
bool relax_along_present(Layout layout, const LinkArrays<float>& links,
                         std::span<const LinkStretch> stretches, RoomView<const float> start,
                         const FreeMotion<float>* motion, const MassRange& masses, PassPlace place,
                         RoomView<float> position) {
  return HWY_DYNAMIC_DISPATCH(relax_singles)(layout, links, stretches, start, motion, masses, place,
                                             position);
}

template <>
bool are_finite(Layout layout, RoomView<const double> position, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(finite_doubles)(layout, position, begin, end);
}

template <>
bool are_finite(Layout layout, RoomView<const float> position, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(finite_singles)(layout, position, begin, end);
}

double energy_of_motion(Layout layout, const MotionEnergy& of, std::span<const double> mass,
                        RoomView<const double> now, RoomView<const double> before) {
  return HWY_DYNAMIC_DISPATCH(energy_of_masses_moved)(layout, of, mass, now, before);
}

bool relax_along_start(Layout layout, const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                       RoomView<const double> start, const FreeMotion<double>* motion,
                       const MassRange& masses, PassPlace place, bool judged, RoomView<double> position,
                       AlongFound& found) {
  return HWY_DYNAMIC_DISPATCH(relax_all_along)(layout, links, stretches, start, motion, masses, place, judged,
                                               position, found);
}

}  // namespace taut

#endif
