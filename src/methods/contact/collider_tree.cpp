#include "contact/collider_tree.h"

#include <algorithm>
#include <numeric>

#include "model/solid_mesh.h"

namespace taut {
namespace {

constexpr std::uint32_t most_in_leaf = 4;

std::vector<std::uint32_t> all_of_them(std::size_t count) {
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

}  // namespace

// Large enough whatever rounding does to distances.
Bounds ColliderTree::box_around(const Shape& shape) {
  Bounds around;
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    around.take_in(sphere->centre, sphere->radius);
  } else if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    around.take_in(capsule->a, capsule->radius);
    around.take_in(capsule->b, capsule->radius);
  } else if (const auto* box = std::get_if<Box>(&shape)) {
    const Vec3 half_size = box->axes.cwiseAbs() * box->half_size;
    around = {box->centre - half_size, box->centre + half_size};
  } else if (const auto* solid = std::get_if<MeshSolid>(&shape)) {
    const Bounds& own = solid->mesh->bounds();
    const Vec3 middle = solid->place(0.5 * (own.low + own.high));
    const Vec3 half_size = solid->axes.cwiseAbs() * (0.5 * (own.high - own.low));
    around = {middle - half_size, middle + half_size};
  }
  const Vec3 slack = 1e-9 * (around.low.cwiseAbs() + around.high.cwiseAbs() + Vec3::Ones());
  return {around.low - slack, around.high + slack};
}

ColliderTree::ColliderTree(const std::vector<Shape>& shapes)
    : ColliderTree(shapes, all_of_them(shapes.size())) {}

ColliderTree::ColliderTree(const std::vector<Shape>& shapes, const std::vector<std::uint32_t>& some)
    : boxes_(shapes.size()) {
  for (const std::uint32_t i : some) {
    boxes_[i] = box_around(shapes[i]);
    (std::holds_alternative<HalfSpace>(shapes[i]) ? everywhere_ : order_).push_back(i);
  }
  if (order_.empty()) return;
  nodes_.emplace_back();
  divide(0, 0, static_cast<std::uint32_t>(order_.size()));
}

Bounds ColliderTree::box_around(std::uint32_t begin, std::uint32_t end) const {
  Bounds around;
  for (std::uint32_t i = begin; i < end; ++i) around.take_in(boxes_[order_[i]]);
  return around;
}

void ColliderTree::divide(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
  nodes_[node] = {box_around(begin, end), begin, end - begin};
  if (end - begin <= most_in_leaf) return;
  int axis = 0;
  (nodes_[node].box.high - nodes_[node].box.low).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto twice_centre = [&](std::uint32_t i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return twice_centre(a) < twice_centre(b); });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = children;
  nodes_[node].count = 0;
  divide(children, begin, middle);
  divide(children + 1, middle, end);
}

void ColliderTree::find(const Vec3& place, double reach, std::vector<std::uint32_t>& near) const {
  near.insert(near.end(), everywhere_.begin(), everywhere_.end());
  if (nodes_.empty()) return;
  Bounds around;
  around.take_in(place, reach);
  find_below(0, around, near);
}

void ColliderTree::find_below(std::uint32_t at, const Bounds& around,
                              std::vector<std::uint32_t>& near) const {
  const Node& node = nodes_[at];
  if (!around.meets(node.box)) return;
  if (node.count == 0) {
    find_below(node.first, around, near);
    find_below(node.first + 1, around, near);
  }
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
    if (around.meets(boxes_[order_[i]])) near.push_back(order_[i]);
}

}  // namespace taut
