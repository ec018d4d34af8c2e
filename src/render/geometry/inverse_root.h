#pragma once

#include <bit>
#include <cstdint>

namespace taut {

/// One over a square root, to six digits: a first guess by halving the exponent, bettered twice by Newton.
/// The library's root sets errno, and no vector can be made of that.
inline float inverse_root(float square) {
  float guess = std::bit_cast<float>(0x5F375A86U - (std::bit_cast<std::uint32_t>(square) >> 1U));
  guess *= 1.5F - 0.5F * square * guess * guess;
  return guess * (1.5F - 0.5F * square * guess * guess);
}

}  // namespace taut
