#include "model/box_tree.h"

#include <bit>

namespace taut {

void BoxTree::fill(const std::vector<Bounds>& boxes) {
  boxes_ = boxes;
  leaves_ = std::bit_ceil(std::max<std::size_t>((boxes.size() + in_leaf - 1) / in_leaf, 1));
  around_.assign(2 * leaves_, Bounds{});
  for (std::size_t leaf = leaves_; leaf < 2 * leaves_; ++leaf)
    for (std::size_t i = begin(leaf); i < end(leaf); ++i) around_[leaf].take_in(boxes_[i]);
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    around_[node] = around_[2 * node];
    around_[node].take_in(around_[2 * node + 1]);
  }
}

}  // namespace taut
