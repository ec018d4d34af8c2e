#include "direct/newton_rounds.h"

#include <algorithm>
#include <limits>

#include "base/vector_operations.h"

namespace taut {

double length_tolerance(const SystemLinks& links, const Vectors& position) {
  return length_tolerance(shortest_length(links), largest_coordinate(position));
}

double shortest_length(const SystemLinks& links) {
  return links.size() == 0 ? 1.0 : all_of(links.length).minCoeff();
}

double length_tolerance(double shortest, double farthest) {
  return std::max(1e-12, 16.0 * std::numeric_limits<double>::epsilon() * farthest / shortest);
}

}  // namespace taut
