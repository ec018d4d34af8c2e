#include "welding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace taut {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t bits = 0;
    for (const std::int64_t part : cell) {
      bits = (bits ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U;
      bits ^= bits >> 29U;
    }
    return static_cast<std::size_t>(bits);
  }
};

}  // namespace

// Those that stand for themselves lie in cells twice as wide as the distance, of which a place within reach
// of it can touch two along each axis.
std::vector<Index> welded(const std::vector<Vec3>& places, double distance) {
  const double width = std::max(2.0 * distance, 1e-12);
  std::unordered_multimap<Cell, Index, CellHash> standing;
  standing.reserve(places.size());
  std::vector<Index> stands_for(places.size());
  for (Index i = 0; i < places.size(); ++i) {
    const Vec3& place = places[i];
    Cell low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = place[static_cast<int>(axis)];
      low[axis] = static_cast<std::int64_t>(std::floor((at - distance) / width));
      high[axis] = static_cast<std::int64_t>(std::floor((at + distance) / width));
    }
    Index found = i;
    for (Cell cell = low; cell[0] <= high[0]; ++cell[0])
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
        for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
          const auto [begin, end] = standing.equal_range(cell);
          for (auto each = begin; each != end; ++each)
            if ((places[each->second] - place).norm() <= distance) found = std::min(found, each->second);
        }
    stands_for[i] = found;
    if (found != i) continue;
    Cell own{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      own[axis] = static_cast<std::int64_t>(std::floor(place[static_cast<int>(axis)] / width));
    standing.emplace(own, i);
  }
  return stands_for;
}

}  // namespace taut
