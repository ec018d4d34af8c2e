#include "direct/newton_rounds.h"

#include <algorithm>
#include <limits>

#include "base/vector_operations.h"

namespace taut {

double length_tolerance(const SystemLinks& links, const Vectors& position) {
  double farthest = 0.0;
  for (const auto* axis : {&position.x, &position.y, &position.z})
    if (!axis->empty()) farthest = std::max(farthest, all_of(*axis).abs().maxCoeff());
  const double shortest = links.size() == 0 ? 1.0 : all_of(links.length).minCoeff();
  return std::max(1e-12, 16.0 * std::numeric_limits<double>::epsilon() * farthest / shortest);
}

}  // namespace taut
