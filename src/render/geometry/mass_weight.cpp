#include "geometry/mass_weight.h"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr double least_size = 0.35, most_size = 6.0;
constexpr double darkening = 0.24;  // the shade is the share of the median to the power of minus this
constexpr double darkest = 0.3;

// The upper one of two; 0 where there is none.
double median_mass(const Model& model) {
  const std::vector<bool> boned = in_ragdoll(model);
  std::vector<double> masses;
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (!boned[i] && !model.masses.pinned(i)) masses.push_back(model.masses.mass[i]);
  if (masses.empty()) return 0.0;
  const auto middle = masses.begin() + static_cast<std::ptrdiff_t>(masses.size() / 2);
  std::nth_element(masses.begin(), middle, masses.end());
  return *middle;
}

}  // namespace

std::vector<MassWeight> mass_weights(const Model& model, const Look& look) {
  std::vector<MassWeight> weights(model.masses.size());
  const double median = median_mass(model);
  if (!look.weights || !(median > 0.0)) return weights;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (model.masses.pinned(i)) continue;
    const double share = model.masses.mass[i] / median;
    weights[i].size = std::clamp(std::cbrt(share), least_size, most_size);
    weights[i].shade = std::clamp(std::pow(share, -darkening), darkest, 1.0);
  }
  return weights;
}

}  // namespace taut
