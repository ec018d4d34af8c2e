#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// The sets of vector instructions that the kernels are made for and this processor has, the one in use when
/// none is forced first: "avx2", "neon" and the like; "scalar" is none. All give the same bits.
std::vector<std::string> simd_targets();

/// Makes all kernels of the process use that one; with an empty name, the best again. Throws BadRequest for
/// one that is not there. Not to be called while anything steps.
void force_simd(std::string_view name);

}  // namespace taut
