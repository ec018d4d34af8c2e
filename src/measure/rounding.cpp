#include "measure/rounding.h"

#include <algorithm>
#include <cmath>

#include "model/measures.h"

namespace taut {
namespace {

double farthest_from_origin(const State& state) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < state.position.size(); ++i)
    farthest = std::max(farthest, state.position.at(i).cwiseAbs().maxCoeff());
  return farthest;
}

}  // namespace

double rounding_error(const Model& model, const State& start, const Settings& settings) {
  const auto precision = settings.values.find("precision");
  if (precision == settings.values.end() || settings.choice("precision") != "single") return 0.0;
  constexpr double half_place = 0x1p-24;
  const double size = scene_size(model, start), reach = farthest_from_origin(start) + size;
  const double h = 1.0 / settings.steps_per_second(), gravity = model.gravity.norm();
  const double lost = half_place * reach, fall = gravity * h * h;
  const double share = fall > 0.0 ? std::min(1.0, lost / fall) : 0.0;
  return share + lost / size;
}

}  // namespace taut
