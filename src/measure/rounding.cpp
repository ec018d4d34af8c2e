#include "measure/rounding.h"

#include <algorithm>
#include <cmath>

#include "base/vector_operations.h"
#include "model/measures.h"

namespace taut {
double rounding_error(const Model& model, const State& start, const Settings& settings) {
  const auto precision = settings.values.find("precision");
  if (precision == settings.values.end() || settings.choice("precision") != "single") return 0.0;
  constexpr double half_place = 0x1p-24;
  const double size = scene_size(model, start), reach = largest_coordinate(start.position) + size;
  const double h = 1.0 / settings.steps_per_second(), gravity = model.gravity.norm();
  const double lost = half_place * reach, fall = gravity * h * h;
  const double share = fall > 0.0 ? std::min(1.0, lost / fall) : 0.0;
  return share + lost / size;
}

}  // namespace taut
