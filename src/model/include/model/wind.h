#pragma once

#include <cstdint>

#include "base/vectors.h"

namespace taut {

/// Air that blows on the triangles of sheets, the same everywhere, with gusts that are a function of time and
/// of a seed.
struct Wind {
  Vec3 velocity = Vec3::Zero();   ///< m/s, without gusts
  double gust = 0.0;              ///< how far gusts reach above and below, as a share of the velocity
  double gust_time = 1.0;         ///< s, from one gust to the next
  std::uint32_t seed = 1;         ///< which gusts
  double density = 1.2;           ///< kg/m³
  double drag_coefficient = 1.2;  ///< of a triangle that faces the wind
  Vec3 up = Vec3::UnitY();        ///< unit length: gusts waver level more than they rise
};

/// The air's velocity at a time (m/s): smooth, and the same for the same seed.
Vec3 wind_at(const Wind& wind, double time);

}  // namespace taut
