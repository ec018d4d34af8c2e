#include "contact/face_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut {

FaceSearch::FaceSearch(const Model& model) : model_(model), mesh_(model) {}

void FaceSearch::links_changed(const State& state) {
  whole_ = whole_faces(mesh_, model_, state.broken_at);
  middles_.clear();
}

// Also measures how much of its room each node uses.
bool FaceSearch::covers(const std::vector<Vec3>& start, const std::vector<Vec3>& end) {
  if (middles_.size() != start.size()) return false;
  used_.resize(start.size());
  bool within = true;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double square =
        std::max((start[i] - middles_[i]).squaredNorm(), (end[i] - middles_[i]).squaredNorm());
    used_[i] = std::sqrt(square);
    within = within && used_[i] <= rooms_[i];
  }
  return within;
}

double FaceSearch::least_distance(const FacePair& pair) const {
  const auto [a, b, c, d] = pair.nodes;
  return pair.distance - (pair.edges ? std::max(used_[a], used_[b]) + std::max(used_[c], used_[d])
                                     : used_[a] + std::max({used_[b], used_[c], used_[d]}));
}

// What a node is given beyond its way in this step: more makes searches rarer, and pairs more.
double FaceSearch::slack_of(std::uint32_t node) const {
  constexpr double slack = 0.5;  // of half a thickness
  if (!mesh_.of_solid(node)) return slack * mesh_.radius[node];
  return mesh_.rides(node) ? slack * mesh_.radius.front() : 0.0;
}

bool FaceSearch::cover(const std::vector<Vec3>& start, const std::vector<Vec3>& end) {
  constexpr double round_up = 1.0 + 1e-12;
  if (covers(start, end)) return false;
  middles_.resize(start.size());
  rooms_.resize(start.size());
  for (std::uint32_t i = 0; i < start.size(); ++i) {
    middles_[i] = 0.5 * (start[i] + end[i]);
    rooms_[i] = round_up * (0.5 * (end[i] - start[i]).norm() + slack_of(i));
  }
  find_face_pairs(mesh_, whole_, middles_, rooms_, std::numeric_limits<std::size_t>::max(), pairs_);
  covers(start, end);
  return true;
}

}  // namespace taut
