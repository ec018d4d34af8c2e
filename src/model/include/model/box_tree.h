#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// A box along the axes. One that was given nothing meets nothing.
struct Bounds {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);  ///< m

  void take_in(const Vec3& point, double radius) {
    low = low.cwiseMin(point - Vec3::Constant(radius));
    high = high.cwiseMax(point + Vec3::Constant(radius));
  }
  void take_in(const Bounds& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool meets(const Bounds& other) const {
    // Without branches: which way they would go can't be guessed.
    int held = 0;
    for (int axis = 0; axis < 3; ++axis)
      held +=
          static_cast<int>(low[axis] <= other.high[axis]) + static_cast<int>(high[axis] >= other.low[axis]);
    return held == 6;
  }
};

/// Finds boxes that meet, by a binary tree of boxes around them. The tree halves the list it is given, so
/// boxes that are near each other should stand near each other in it; then no more is looked at than meets,
/// or nearly.
class BoxTree {
 public:
  /// Takes over boxes, which are told apart by their places in the list.
  void fill(const std::vector<Bounds>& boxes);

  /// Calls visit(i, j), i < j, once for each pair of its boxes that meet.
  template <class Visit>
  void visit_pairs(const Visit& visit) const {
    visit_pairs(0, 1, visit);
  }
  /// The same for those whose first box is in one of several sections, that follow each other in the list.
  template <class Visit>
  void visit_pairs(std::size_t section, std::size_t sections, const Visit& visit) const {
    if (boxes_.empty()) return;
    visit_within(sections + section, visit);
    for (std::size_t later = section + 1; later < sections; ++later)
      visit_between(sections + section, *this, sections + later, visit);
  }

  /// Calls visit(i, j) once for each box i of this tree and each j of another that meet.
  template <class Visit>
  void visit_pairs(const BoxTree& other, const Visit& visit) const {
    visit_pairs(0, 1, other, visit);
  }
  /// The same for those whose first box is in a section of this tree.
  template <class Visit>
  void visit_pairs(std::size_t section, std::size_t sections, const BoxTree& other,
                   const Visit& visit) const {
    if (!boxes_.empty() && !other.boxes_.empty()) visit_between(sections + section, other, 1, visit);
  }

  /// Into how many sections it can be cut: at most so many, a power of two.
  std::size_t sections(std::size_t most) const { return std::min(most, leaves_); }

 private:
  static constexpr std::size_t in_leaf = 4;

  bool is_leaf(std::size_t node) const { return node >= leaves_; }
  std::size_t begin(std::size_t leaf) const { return std::min((leaf - leaves_) * in_leaf, boxes_.size()); }
  std::size_t end(std::size_t leaf) const { return std::min((leaf - leaves_ + 1) * in_leaf, boxes_.size()); }

  template <class Visit>
  void visit_within(std::size_t node, const Visit& visit) const {
    if (!is_leaf(node)) {
      visit_within(2 * node, visit);
      visit_within(2 * node + 1, visit);
      visit_between(2 * node, *this, 2 * node + 1, visit);
      return;
    }
    for (std::size_t i = begin(node); i < end(node); ++i)
      for (std::size_t j = i + 1; j < end(node); ++j)
        if (boxes_[i].meets(boxes_[j])) visit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  }

  template <class Visit>
  void visit_between(std::size_t a, const BoxTree& other, std::size_t b, const Visit& visit) const {
    if (!around_[a].meets(other.around_[b])) return;
    if (!is_leaf(a)) {
      visit_halves(a, other, b, visit);
    } else if (!other.is_leaf(b)) {
      visit_between(a, other, 2 * b, visit);
      visit_between(a, other, 2 * b + 1, visit);
    } else {
      for (std::size_t i = begin(a); i < end(a); ++i)
        for (std::size_t j = other.begin(b); j < other.end(b); ++j)
          if (boxes_[i].meets(other.boxes_[j]))
            visit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    }
  }

  // Both nodes in halves, where there are any.
  template <class Visit>
  void visit_halves(std::size_t a, const BoxTree& other, std::size_t b, const Visit& visit) const {
    for (const std::size_t half : {2 * a, 2 * a + 1})
      if (other.is_leaf(b)) {
        visit_between(half, other, b, visit);
      } else {
        visit_between(half, other, 2 * b, visit);
        visit_between(half, other, 2 * b + 1, visit);
      }
  }

  std::vector<Bounds> boxes_;
  std::vector<Bounds> around_;  // of each node: 1 is the root, 2 n and 2 n + 1 are the halves of n
  std::size_t leaves_ = 1;      // a power of two, and the number of the first of them
};

}  // namespace taut
