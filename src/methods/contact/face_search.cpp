#include "contact/face_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace taut {

FaceSearch::FaceSearch(const Model& model, std::shared_ptr<Workers> workers)
    : model_(model), mesh_(model), workers_(std::move(workers)) {}

void FaceSearch::links_changed(const State& state) {
  whole_ = whole_faces(mesh_, model_, state.broken_at);
  middles_.clear();
}

void FaceSearch::begin_step(const std::vector<Vec3>& start, const std::vector<Vec3>& end) {
  room_shift_ += room_way_;
  room_way_ = Vec3::Zero();
  for (std::size_t i = 0; i < mesh_.mass.size(); ++i) room_way_ += end[i] - start[i];
  room_way_ /= static_cast<double>(mesh_.mass.size());
}

// Also measures how much of its room each node uses.
bool FaceSearch::covers(const std::vector<Vec3>& start, const std::vector<Vec3>& end) {
  if (middles_.size() != start.size()) return false;
  used_.resize(start.size());
  const Vec3 at_end = room_shift_ + room_way_;
  bool within = true;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double square = std::max((start[i] - room_shift_ - middles_[i]).squaredNorm(),
                                   (end[i] - at_end - middles_[i]).squaredNorm());
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

// What a node is given beyond its way in this step: more makes searches rarer, and pairs more. Nodes of
// solids and balls are few, but for those of meshes, and may be what all rooms move away from.
double FaceSearch::slack_of(std::uint32_t node) const {
  constexpr double slack = 0.5, of_balls = 2.0, of_solids = 8.0, of_meshes = 3.0;  // half thicknesses
  if (mesh_.is_ball(node)) return of_balls * mesh_.radius.front();
  if (!mesh_.of_solid(node)) return slack * mesh_.radius[node];
  const bool is_mesh = std::holds_alternative<MeshSolid>(mesh_.groups[mesh_.group[node]].solid->shape);
  return (is_mesh ? of_meshes : of_solids) * mesh_.radius.front();
}

bool FaceSearch::cover(const std::vector<Vec3>& start, const std::vector<Vec3>& end) {
  constexpr double round_up = 1.0 + 1e-12;
  if (covers(start, end)) return false;
  room_shift_ = Vec3::Zero();
  middles_.resize(start.size());
  rooms_.resize(start.size());
  for (std::uint32_t i = 0; i < start.size(); ++i) {
    const Vec3 seen_end = end[i] - room_way_;
    middles_[i] = 0.5 * (start[i] + seen_end);
    rooms_[i] = round_up * (0.5 * (seen_end - start[i]).norm() + slack_of(i));
  }
  search_.find(mesh_, whole_, middles_, rooms_, std::numeric_limits<std::size_t>::max(), workers_.get(),
               pairs_);
  covers(start, end);
  return true;
}

}  // namespace taut
