#pragma once

#include <memory>
#include <vector>

#include "base/workers.h"
#include "model/face_pair_search.h"
#include "model/state.h"

namespace taut {

/// The pairs of a model's faces and solids that may meet in a step, looked for anew only when nodes have left
/// the room they were given at the last search. When that was changes nothing but the time it takes: the
/// pairs come in an order of their own, and what is too far away to matter in a step is passed over by its
/// user.
class FaceSearch {
 public:
  /// `workers` share the search; null: this thread alone.
  FaceSearch(const Model& model, std::shared_ptr<Workers> workers);

  const FaceMesh& mesh() const { return mesh_; }
  const WholeFaces& whole() const { return whole_; }

  /// To be called before the first step and whenever other links are whole than before.
  void links_changed(const State& state);

  /// To be called when a step begins, with where nodes start and are going.
  void begin_step(const std::vector<Vec3>& start, const std::vector<Vec3>& end);

  /// Makes the pairs good for nodes that move straight from start to end; whether they were looked for anew.
  bool cover(const std::vector<Vec3>& start, const std::vector<Vec3>& end);

  const std::vector<FacePair>& pairs() const { return pairs_; }

  /// A distance (m) that a pair does not come below on these straight ways: quickly had, and enough for most.
  double least_distance(const FacePair& pair) const;

 private:
  bool covers(const std::vector<Vec3>& start, const std::vector<Vec3>& end);

  double slack_of(std::uint32_t node) const;

  const Model& model_;
  FaceMesh mesh_;
  WholeFaces whole_;
  std::shared_ptr<Workers> workers_;
  FacePairSearch search_;
  std::vector<FacePair> pairs_;
  // All rooms move on together, as sheets do in the mean: a way that all go alone changes no distance.
  Vec3 room_way_ = Vec3::Zero();    // m, in this step …
  Vec3 room_shift_ = Vec3::Zero();  // m, … and from the last search to its start
  std::vector<Vec3> middles_;       // m, of each node's room at the last search; none: pairs are not known
  std::vector<double> rooms_;       // m, their radii
  std::vector<double> used_;        // m of that, by the ways that were covered last
};

}  // namespace taut
