#include "model/box_grid.h"

#include <bit>

namespace taut {
namespace {

// Of cells at least as wide as the box: 2^level m.
int level_for(const Bounds& box) {
  constexpr int finest = -40, coarsest = 60;
  const double extent = (box.high - box.low).maxCoeff();
  if (!(extent > 0.0)) return finest;
  return std::clamp(std::ilogb(extent) + 1, finest, coarsest);
}

}  // namespace

BoxGrid::Cell BoxGrid::cell_at(const Vec3& place, double size) {
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const double at = std::floor(place[axis] / size);
    // What is not a number meets nothing, wherever it is put.
    cell[static_cast<std::size_t>(axis)] =
        std::isnan(at) ? 0 : static_cast<std::int64_t>(std::clamp(at, -1e15, 1e15));
  }
  return cell;
}

std::size_t BoxGrid::bucket_of(const Cell& cell, int level) const {
  auto hash = static_cast<std::uint64_t>(level + 64);
  for (const std::int64_t at : cell) hash = (hash ^ static_cast<std::uint64_t>(at)) * 0x9e3779b97f4a7c15U;
  return (hash >> 32U) & (begins_.size() - 2);
}

// Counting sort by bucket.
void BoxGrid::fill(const std::vector<Bounds>& boxes) {
  begins_.assign(std::bit_ceil(boxes.size() + 1) + 1, 0U);
  entries_.resize(boxes.size());
  entries_level_.resize(boxes.size());
  levels_.clear();
  std::vector<std::size_t> bucket(boxes.size());
  std::vector<Cell> cells(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const int level = level_for(boxes[i]);
    entries_level_[i] = level;
    if (std::ranges::find(levels_, level) == levels_.end()) levels_.push_back(level);
    cells[i] = cell_at(0.5 * (boxes[i].low + boxes[i].high), std::ldexp(1.0, level));
    bucket[i] = bucket_of(cells[i], level);
    ++begins_[bucket[i] + 1];
  }
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    entries_[next[bucket[i]]++] = {boxes[i], cells[i], entries_level_[i], static_cast<std::uint32_t>(i)};
}

}  // namespace taut
