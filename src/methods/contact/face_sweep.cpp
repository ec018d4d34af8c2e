#include "contact/face_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace taut {
namespace {

double longest_way(const FacePair& pair, const std::array<Vec3, 4>& ways) {
  const Vec3 mean = 0.25 * ((ways[0] + ways[1]) + (ways[2] + ways[3]));
  double first = 0.0, other = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    double& most = k < pair.first_of_other() ? first : other;
    most = std::max(most, (ways[k] - mean).squaredNorm());
  }
  return std::sqrt(first) + std::sqrt(other);
}

std::array<Vec3, 4> ways_of(const FacePair& pair, const std::vector<Vec3>& start,
                            const std::vector<Vec3>& end) {
  std::array<Vec3, 4> ways;
  for (std::size_t k = 0; k < 4; ++k) ways[k] = end[pair.nodes[k]] - start[pair.nodes[k]];
  return ways;
}

}  // namespace

double most_approach(const FacePair& pair, const std::vector<Vec3>& start, const std::vector<Vec3>& end) {
  return longest_way(pair, ways_of(pair, start, end));
}

FaceMeeting first_meeting(const FacePair& pair, const std::vector<Vec3>& start, const std::vector<Vec3>& end,
                          double distance_at_start, double stop) {
  constexpr double cautious = 0.9, near = 0.1;
  constexpr int most_moves = 1000;  // far more than there ever are
  const std::array<Vec3, 4> ways = ways_of(pair, start, end);
  const double approach = longest_way(pair, ways), excess_at_start = distance_at_start - stop;
  FaceMeeting meeting;
  if (approach < excess_at_start || !(excess_at_start > 0.0)) return meeting;
  std::array<Vec3, 4> corners;
  double time = 0.0, excess = excess_at_start;
  for (int moves = 0; moves < most_moves; ++moves) {
    time += cautious * excess / approach;
    if (time >= 1.0) return meeting;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = start[pair.nodes[k]] + time * ways[k];
    meeting.gap = nearest_gap(pair.edges, corners);
    excess = meeting.gap.distance - stop;
    if (!(excess > near * excess_at_start)) break;
  }
  meeting.met = true;
  return meeting;
}

}  // namespace taut
