#pragma once

#include <cstdint>
#include <vector>

#include "model/box_tree.h"
#include "model/model.h"

namespace taut {

/// Finds the solids near a place without looking at all of them: a tree of boxes around them, halved at the
/// median. Half-spaces have no box and are near everywhere.
class ColliderTree {
 public:
  explicit ColliderTree(const std::vector<Shape>& shapes);

  /// Of some of the shapes alone.
  ColliderTree(const std::vector<Shape>& shapes, const std::vector<std::uint32_t>& some);

  /// Adds the solids whose surfaces may be nearer to a place than `reach` (m): all that are, and few others.
  void find(const Vec3& place, double reach, std::vector<std::uint32_t>& near) const;

 private:
  // A box around some of the solids. A leaf holds solids, others hold the two nodes that follow each other.
  struct Node {
    Bounds box;
    std::uint32_t first;  // of the solids in order_, or of the two nodes
    std::uint32_t count;  // of solids; 0: no leaf
  };

  static Bounds box_around(const Shape& shape);
  Bounds box_around(std::uint32_t begin, std::uint32_t end) const;
  void find_below(std::uint32_t node, const Bounds& around, std::vector<std::uint32_t>& near) const;
  void divide(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  std::vector<std::uint32_t> everywhere_;
  std::vector<std::uint32_t> order_;
  std::vector<Bounds> boxes_;  // of each solid
  std::vector<Node> nodes_;
};

}  // namespace taut
