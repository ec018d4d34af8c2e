#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// A box along the axes.
struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< m

  void take_in(const Vec3& point, double radius) {
    low = low.cwiseMin(point - Vec3::Constant(radius));
    high = high.cwiseMax(point + Vec3::Constant(radius));
  }
  bool meets(const Bounds& other) const {
    return (low.array() <= other.high.array()).all() && (high.array() >= other.low.array()).all();
  }
  static Bounds around(const Vec3& point, double radius) {
    return {point - Vec3::Constant(radius), point + Vec3::Constant(radius)};
  }
};

/// Finds boxes that meet others, on a hashed grid (Teschner et al., Optimized Spatial Hashing for Collision
/// Detection of Deformable Objects, 2003) with cells of several sizes: a box stands in the one cell that its
/// middle is in, of cells at least as wide as itself, so that large ones don't fill many cells and small ones
/// don't share few.
class BoxGrid {
 public:
  /// Takes over boxes, which are told apart by their places in the list.
  void fill(const std::vector<Bounds>& boxes);

  /// Calls visit(box) for each that meets the query, in no order that means anything; only those in cells no
  /// smaller than `least_level`'s.
  template <class Visit>
  void visit(const Bounds& query, int least_level, const Visit& visit) const {
    for (const int level : levels_) {
      if (level < least_level) continue;
      const double cell = std::ldexp(1.0, level);
      const Vec3 half = Vec3::Constant(0.5 * cell);
      const Cell from = cell_at(query.low - half, cell), to = cell_at(query.high + half, cell);
      for (std::int64_t z = from[2]; z <= to[2]; ++z)
        for (std::int64_t y = from[1]; y <= to[1]; ++y)
          for (std::int64_t x = from[0]; x <= to[0]; ++x) visit_cell({x, y, z}, level, query, visit);
    }
  }

  /// The level of one of the boxes: that of its cells.
  int level(std::uint32_t box) const { return entries_level_[box]; }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Bounds bounds;
    Cell cell;
    int level;
    std::uint32_t box;
  };

  static Cell cell_at(const Vec3& place, double size);
  std::size_t bucket_of(const Cell& cell, int level) const;

  template <class Visit>
  void visit_cell(const Cell& cell, int level, const Bounds& query, const Visit& visit) const {
    const std::size_t bucket = bucket_of(cell, level);
    for (std::uint32_t k = begins_[bucket]; k < begins_[bucket + 1]; ++k) {
      const Entry& entry = entries_[k];
      if (entry.cell == cell && entry.level == level && entry.bounds.meets(query)) visit(entry.box);
    }
  }

  std::vector<int> levels_, entries_level_;
  std::vector<Entry> entries_;         // bucket after bucket
  std::vector<std::uint32_t> begins_;  // of each bucket
};

}  // namespace taut
