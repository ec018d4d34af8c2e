#include "geometry/occluders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/inverse_root.h"

namespace taut {
namespace {

// Balls at once, in step, so that the compiler makes vectors of them.
constexpr Index lanes = 8;
using Lanes = std::array<float, lanes>;

struct Run {
  const float *x, *y, *z, *area;
};

struct Seen {
  glm::vec3 place, normal;
  float per_square;
};

// Adds what the first so many balls of a run hide, in front more and behind less, and on both sides together.
// Without comparisons, which would make branches.
void add_run(const Run& run, Index count, const Seen& from, Lanes& difference, Lanes& sum) {
  constexpr float pi = std::numbers::pi_v<float>;
  Lanes shares;
  for (Index i = 0; i < lanes; ++i) {
    const float x = run.x[i] - from.place.x, y = run.y[i] - from.place.y, z = run.z[i] - from.place.z;
    const float square = x * x + y * y + z * z;
    const float facing = from.normal.x * x + from.normal.y * y + from.normal.z * z;
    const float left = 1.0F - square * from.per_square;
    const float near = 0.5F * (left + std::abs(left));
    const float area = run.area[i];
    shares[i] = near * near * area * facing * inverse_root(square) / (pi * square + area + 1e-30F);
  }
  for (Index i = count; i < lanes; ++i) shares[i] = 0.0F;
  for (Index i = 0; i < lanes; ++i) {
    difference[i] += shares[i];
    sum[i] += std::abs(shares[i]);
  }
}

}  // namespace

Occluders::Occluders(const std::vector<glm::vec3>& places, const std::vector<float>& areas, float reach)
    : reach_(reach) {
  low_ = glm::vec3(std::numeric_limits<float>::max());
  glm::vec3 high(std::numeric_limits<float>::lowest());
  std::vector<Index> kept;
  kept.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!(areas[i] > 0.0F)) continue;
    kept.push_back(static_cast<Index>(i));
    low_ = glm::min(low_, places[i]);
    high = glm::max(high, places[i]);
  }
  if (kept.empty()) low_ = high = glm::vec3(0.0F);
  // What has fallen far away must not take all memory.
  constexpr float most = 64.0F;
  const glm::vec3 size = high - low_;
  cell_size_ = std::max({reach, size.x / most, size.y / most, size.z / most});
  cells_ = glm::ivec3(size / cell_size_) + 1;

  first_.assign(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) *
                        static_cast<std::size_t>(cells_.z) +
                    1,
                0);
  for (const Index i : kept) ++first_[number_of(cell_at(places[i])) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  // Room for lanes that reach beyond the last one: without an area they hide nothing.
  for (std::vector<float>& along : places_) along.assign(kept.size() + lanes, 0.0F);
  areas_.assign(kept.size() + lanes, 0.0F);
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (const Index i : kept) {
    const Index at = next[number_of(cell_at(places[i]))]++;
    for (int axis = 0; axis < 3; ++axis) places_[static_cast<std::size_t>(axis)][at] = places[i][axis];
    areas_[at] = areas[i];
  }
}

glm::ivec3 Occluders::cell_at(const glm::vec3& place) const {
  return glm::clamp(glm::ivec3(glm::floor((place - low_) / cell_size_)), glm::ivec3(0), cells_ - 1);
}

std::size_t Occluders::number_of(const glm::ivec3& cell) const {
  const auto row = static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(cells_.y) +
                   static_cast<std::size_t>(cell.y);
  return row * static_cast<std::size_t>(cells_.x) + static_cast<std::size_t>(cell.x);
}

glm::vec2 Occluders::hidden(const glm::vec3& place, const glm::vec3& normal) const {
  const glm::ivec3 low = cell_at(place - reach_), high = cell_at(place + reach_);
  Lanes difference{}, sum{};
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y) {
      // Cells of a row stand one behind the other.
      const Index first = first_[number_of({low.x, y, z})], last = first_[number_of({high.x, y, z}) + 1];
      for (Index run = first; run < last; run += lanes)
        add_run(
            {places_[0].data() + run, places_[1].data() + run, places_[2].data() + run, areas_.data() + run},
            std::min(last - run, lanes), {place, normal, 1.0F / (reach_ * reach_)}, difference, sum);
    }
  glm::vec2 hidden(0.0F);
  for (Index lane = 0; lane < lanes; ++lane)
    hidden += 0.5F * glm::vec2(sum[lane] + difference[lane], sum[lane] - difference[lane]);
  return hidden;
}

}  // namespace taut
