#pragma once

#include "relax/kernels.h"

namespace taut {

/// The kernels for one layout and the instructions of the processor at hand: kernels.h says what they do.
template <class Real>
struct LayoutKernels {
  bool (*relax)(const LinkArrays<Real>&, std::span<const LinkStretch>, RoomView<const Real>,
                const FreeMotion<Real>*, const MassRange&, PassPlace, RoomView<Real>);
  bool (*finite)(RoomView<const Real>, std::size_t, std::size_t);
};
using AlongKernel = bool (*)(const LinkArrays<double>&, std::span<const LinkStretch>, RoomView<const double>,
                             const FreeMotion<double>*, const MassRange&, PassPlace, bool, RoomView<double>,
                             AlongFound&);

LayoutKernels<double> packed_double_kernels();
LayoutKernels<double> split_double_kernels();
LayoutKernels<float> packed_single_kernels();
LayoutKernels<float> split_single_kernels();
AlongKernel packed_along_kernel();
AlongKernel split_along_kernel();

}  // namespace taut
