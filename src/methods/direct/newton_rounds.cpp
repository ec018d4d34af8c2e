#include "direct/newton_rounds.h"

#include <algorithm>
#include <limits>

#include "base/vector_operations.h"

namespace taut {

double length_tolerance(const SystemLinks& links, const Vectors& position) {
  const double farthest = largest_coordinate(position);
  const double shortest = links.size() == 0 ? 1.0 : all_of(links.length).minCoeff();
  return std::max(1e-12, 16.0 * std::numeric_limits<double>::epsilon() * farthest / shortest);
}

}  // namespace taut
