#include "model/near_balls.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace taut {

NearBalls::NearBalls(std::vector<BodyBall> balls, double margin) : balls_(std::move(balls)), margin_(margin) {
  sort_into_levels();
  grid_.begins.resize(2 * std::bit_ceil(balls_.size() + 1) + 1);
}

// The cells of the first level are as wide as the largest ball reaches; each level after it has cells that
// were halved more often. Only levels that have balls are there.
void NearBalls::sort_into_levels() {
  const auto reach = [&](const BodyBall& ball) { return 2.0 * ball.radius + margin_; };
  double widest = 0.0;
  for (const BodyBall& ball : balls_) widest = std::max(widest, reach(ball));
  std::map<int, std::uint32_t> levels;  // by how often cells were halved
  for (const BodyBall& ball : balls_) levels.emplace(std::ilogb(widest / reach(ball)), 0U);
  for (auto& [halvings, number] : levels) {
    number = static_cast<std::uint32_t>(levels_.size());
    levels_.push_back({std::ldexp(widest, -halvings), number});
  }
  for (const BodyBall& ball : balls_) level_of_.push_back(levels[std::ilogb(widest / reach(ball))]);
}

std::size_t NearBalls::bucket_of(const Cell& cell, const Level& level) const {
  std::uint64_t hash = level.number;
  for (const std::int64_t at : cell) hash = (hash ^ static_cast<std::uint64_t>(at)) * 0x9e3779b97f4a7c15U;
  return (hash >> 32U) & (grid_.begins.size() - 2);
}

NearBalls::Cell NearBalls::cell_at(const Vec3& place, const Level& level) {
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const double at = std::floor(place[axis] / level.cell_size);
    // What is not a number meets nothing, wherever it is put.
    cell[static_cast<std::size_t>(axis)] =
        std::isnan(at) ? 0 : static_cast<std::int64_t>(std::clamp(at, -1e15, 1e15));
  }
  return cell;
}

// Counting sort of the balls by bucket.
void NearBalls::fill_grid(const std::vector<Vec3>& centres) {
  grid_.cells.resize(balls_.size());
  grid_.balls.resize(balls_.size());
  grid_.beyond.resize(balls_.size());
  std::fill(grid_.begins.begin(), grid_.begins.end(), 0U);
  for (std::uint32_t i = 0; i < balls_.size(); ++i) {
    grid_.cells[i] = cell_at(centres[i], level_of(i));
    ++grid_.begins[bucket_of(grid_.cells[i], level_of(i)) + 1];
  }
  for (std::size_t bucket = 1; bucket < grid_.begins.size(); ++bucket)
    grid_.begins[bucket] += grid_.begins[bucket - 1];
  std::vector<std::uint32_t> next(grid_.begins.begin(), grid_.begins.end() - 1);
  for (std::uint32_t i = 0; i < balls_.size(); ++i)
    grid_.balls[next[bucket_of(grid_.cells[i], level_of(i))]++] = i;
  for (std::size_t bucket = 0; bucket + 1 < grid_.begins.size(); ++bucket)
    for (std::uint32_t k = grid_.begins[bucket + 1]; k-- > grid_.begins[bucket];) {
      const bool goes_on =
          k + 1 < grid_.begins[bucket + 1] && balls_[grid_.balls[k]].body == balls_[grid_.balls[k + 1]].body;
      grid_.beyond[k] = goes_on ? grid_.beyond[k + 1] : k + 1;
    }
}

// Pairs of this ball and others in the cells around it: of its own level later ones, of levels of larger
// balls all, which look for no smaller ones themselves.
void NearBalls::find_pairs(std::uint32_t ball, const std::vector<Vec3>& centres, Pairs& pairs) const {
  for (std::uint32_t number = 0; number <= level_of_[ball]; ++number) {
    const Level& level = levels_[number];
    const Cell home = cell_at(centres[ball], level);
    for (int around = 0; around < 27; ++around)
      find_pairs_in({home[0] + around % 3 - 1, home[1] + around / 3 % 3 - 1, home[2] + around / 9 - 1}, level,
                    ball, centres, pairs);
  }
}

void NearBalls::find_pairs_in(const Cell& cell, const Level& level, std::uint32_t ball,
                              const std::vector<Vec3>& centres, Pairs& pairs) const {
  const BodyBall& here = balls_[ball];
  const bool own = level.number == level_of_[ball];
  const std::size_t bucket = bucket_of(cell, level);
  for (std::uint32_t k = grid_.begins[bucket]; k < grid_.begins[bucket + 1];) {
    const std::uint32_t other = grid_.balls[k];
    const BodyBall& met = balls_[other];
    if (met.body == here.body) {
      k = grid_.beyond[k];  // a body may have many balls here, and none of them counts
      continue;
    }
    ++k;
    if ((own && other <= ball) || level_of_[other] != level.number || grid_.cells[other] != cell) continue;
    const double reach = here.radius + met.radius + margin_;
    if (!((centres[ball] - centres[other]).squaredNorm() <= reach * reach)) continue;
    pairs.emplace_back(std::minmax(ball, other));
  }
}

void NearBalls::find(const std::vector<Vec3>& centres, std::size_t most, Pairs& pairs) {
  pairs.clear();
  fill_grid(centres);
  for (std::uint32_t ball = 0; ball < balls_.size() && pairs.size() <= most; ++ball)
    find_pairs(ball, centres, pairs);
  if (pairs.size() <= most) std::sort(pairs.begin(), pairs.end());
}

}  // namespace taut
