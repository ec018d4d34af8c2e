#include "direct/newton_rounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut {

double length_tolerance(const SystemLinks& links, const Vectors& position) {
  double farthest = 0.0;
  for (const auto* axis : {&position.x, &position.y, &position.z})
    for (const double value : *axis) farthest = std::max(farthest, std::abs(value));
  const double shortest =
      links.size() == 0 ? 1.0 : *std::min_element(links.length.begin(), links.length.end());
  return std::max(1e-12, 16.0 * std::numeric_limits<double>::epsilon() * farthest / shortest);
}

}  // namespace taut
