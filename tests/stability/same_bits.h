#pragma once

#include <cstring>
#include <vector>

#include "model/state.h"

namespace taut::test {

inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

inline bool same_bits(const Vectors& a, const Vectors& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

/// Whether two states are the same bit for bit, NaN and all.
inline bool same_bits(const State& a, const State& b) {
  return std::memcmp(&a.time, &b.time, sizeof a.time) == 0 && same_bits(a.position, b.position) &&
         same_bits(a.velocity, b.velocity) && same_bits(a.tension, b.tension) &&
         same_bits(a.broken_at, b.broken_at);
}

}  // namespace taut::test
