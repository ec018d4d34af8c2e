#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/contact_points.h"
#include "contact/friction.h"

namespace taut {

/// Contact between the contact points of different bodies, as balls. Pairs that may meet are looked for once
/// a step on a hashed grid (Teschner et al., Optimized Spatial Hashing for Collision Detection, 2003).
class BodyContacts {
 public:
  explicit BodyContacts(const Model& model);

  /// To be called once positions of the step have been predicted; `start` are those at its start, `slips`
  /// what contacts with static friction had slipped there.
  void begin_step(const std::vector<ContactSlip>& slips, const Vectors& start, const Vectors& predicted);

  /// One pass over the pairs: pushes those that overlap apart, and takes from their sliding on one another
  /// what friction allows.
  void solve(Vectors& position);

  /// Whether any have touched in this step.
  bool touched() const { return touched_; }

  /// How far contacts with static friction have slipped at the end of the step.
  void keep(const Vectors& position, std::vector<ContactSlip>& slips) const;

 private:
  using Cell = std::array<std::int64_t, 3>;

  // Tables of the grid, kept to save their memory.
  struct Grid {
    std::vector<Cell> cells;            // of each ball
    std::vector<std::uint32_t> begins;  // of each bucket
    std::vector<std::uint32_t> balls;   // bucket after bucket
  };

  bool moved_since_search(const Vectors& position) const;
  Vec3 moved(std::uint32_t a, std::uint32_t b, const Vectors& position) const;
  std::size_t bucket_of(const Cell& cell) const;
  void fill_grid(const std::vector<Vec3>& centres);
  void find_pairs(std::uint32_t ball, const std::vector<Vec3>& centres);

  ContactPoints points_;
  std::vector<std::uint32_t> balls_;  // those of the points that touch others
  double cell_size_ = 0.0;            // m
  Grid grid_;
  std::vector<Vec3> centres_;                                   // at the last search
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;  // of points
  std::vector<StickingFriction> frictions_;  // one a pair, of this step; none without static friction
  const Vectors* start_ = nullptr;
  bool touched_ = false;
};

}  // namespace taut
