#include "model/wind.h"

#include <cmath>

namespace taut {
namespace {

// A number from −1 to 1 for each counter and seed, as good as random (the finaliser of SplitMix64).
double scattered(std::int64_t counter, std::uint64_t seed) {
  std::uint64_t z = static_cast<std::uint64_t>(counter) * 0x9e3779b97f4a7c15U + seed * 0xd1b54a32d192ed03U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  z ^= z >> 31U;
  return static_cast<double>(z >> 11U) * 0x1p-52 - 1.0;
}

// Value noise: a scattered number at every whole place, a quintic between them.
double noise(double at, std::uint64_t seed) {
  const double floor = std::floor(at), u = at - floor;
  const auto place = static_cast<std::int64_t>(floor);
  const double blend = u * u * u * (u * (6.0 * u - 15.0) + 10.0);
  return (1.0 - blend) * scattered(place, seed) + blend * scattered(place + 1, seed);
}

}  // namespace

Vec3 wind_at(const Wind& wind, double time) {
  if (wind.gust == 0.0) return wind.velocity;
  const double at = time / wind.gust_time;
  const std::uint64_t seed = 4U * static_cast<std::uint64_t>(wind.seed);
  // Slow gusts and, half as strong, ones three times as fast; the direction wavers a third as much.
  const double along = (noise(at, seed) + 0.5 * noise(3.0 * at, seed + 1)) / 1.5;
  const Vec3 across = wind.velocity.cross(wind.up);
  return wind.velocity * (1.0 + wind.gust * along) + across * (wind.gust / 3.0 * noise(at, seed + 2)) +
         wind.up * (wind.velocity.norm() * wind.gust / 6.0 * noise(2.0 * at, seed + 3));
}

}  // namespace taut
