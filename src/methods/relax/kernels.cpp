#include "relax/kernels.h"

#include "relax/layout_kernels.h"

namespace taut {
namespace {

LayoutKernels<double> kernels_for(Layout layout, double) {
  return layout == Layout::packed ? packed_double_kernels() : split_double_kernels();
}
LayoutKernels<float> kernels_for(Layout layout, float) {
  return layout == Layout::packed ? packed_single_kernels() : split_single_kernels();
}

}  // namespace

template <class Real>
bool relax_along_present(Layout layout, const LinkArrays<Real>& links, std::span<const LinkStretch> stretches,
                         RoomView<const Real> start, const FreeMotion<Real>* motion, const MassRange& masses,
                         PassPlace place, RoomView<Real> position) {
  return kernels_for(layout, Real()).relax(links, stretches, start, motion, masses, place, position);
}

template <class Real>
bool are_finite(Layout layout, RoomView<const Real> position, std::size_t begin, std::size_t end) {
  return kernels_for(layout, Real()).finite(position, begin, end);
}

template bool relax_along_present(Layout, const LinkArrays<double>&, std::span<const LinkStretch>,
                                  RoomView<const double>, const FreeMotion<double>*, const MassRange&,
                                  PassPlace, RoomView<double>);
template bool relax_along_present(Layout, const LinkArrays<float>&, std::span<const LinkStretch>,
                                  RoomView<const float>, const FreeMotion<float>*, const MassRange&,
                                  PassPlace, RoomView<float>);
template bool are_finite(Layout, RoomView<const double>, std::size_t, std::size_t);
template bool are_finite(Layout, RoomView<const float>, std::size_t, std::size_t);

bool relax_along_start(Layout layout, const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                       RoomView<const double> start, const FreeMotion<double>* motion,
                       const MassRange& masses, PassPlace place, bool judged, RoomView<double> position,
                       AlongFound& found) {
  const AlongKernel along = layout == Layout::packed ? packed_along_kernel() : split_along_kernel();
  return along(links, stretches, start, motion, masses, place, judged, position, found);
}

}  // namespace taut
