#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "model/box_tree.h"
#include "model/face_pairs.h"

namespace taut {

/// find_face_pairs() for those who search over and over: it keeps the room that it works in, and shares the
/// work out among threads. What it finds, and in which order, is the same on any number of them.
class FacePairSearch {
 public:
  /// `workers` may be null: this thread alone.
  void find(const FaceMesh& mesh, const WholeFaces& whole, const std::vector<Vec3>& places,
            const std::vector<double>& rooms, std::size_t most, Workers* workers,
            std::vector<FacePair>& pairs);

 private:
  // Some points, edges or triangles in a tree of the boxes around them, and which they are.
  struct Parts {
    std::vector<std::uint32_t> numbers;
    std::vector<Bounds> bounds;
    BoxTree tree;
  };
  // A pair by its two numbers, the first in the upper half, and its distance (m).
  using KeyedPair = std::pair<std::uint64_t, double>;
  // A section of a tree, whose parts come before those of the next job.
  struct Job {
    const Parts* parts = nullptr;
    std::size_t section = 0, sections = 1;
    std::vector<KeyedPair> found;
  };
  struct Query;

  static void gather(const Query& query, const Bounds& sheets, std::size_t which, Parts& parts);
  void make_jobs(const Parts& one, const Parts* other);
  void find_points(const Query& query, Job& job) const;
  void find_edges(const Query& query, Job& job) const;
  template <class Find>
  void run(Workers* workers, const Find& find);
  template <class Make>
  void take(Workers* workers, std::vector<FacePair>& pairs, const Make& make) const;

  // Of sheets and of solids: edges, triangles, points.
  std::array<Parts, 6> parts_;
  std::vector<Job> jobs_;
  std::size_t job_count_ = 0;
};

}  // namespace taut
