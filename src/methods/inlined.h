#pragma once

#include <hwy/highway.h>

/// A lambda that is part of the loop it stands in: for kernels that are made once for every set of vector
/// instructions, whose lambdas have to be made for the same.
#define TAUT_INLINED HWY_ATTR __attribute__((always_inline))
