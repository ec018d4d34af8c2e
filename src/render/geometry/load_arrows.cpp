#include "geometry/load_arrows.h"

#include <algorithm>
#include <iterator>

#include "geometry/view_matrices.h"

namespace taut {
namespace {

constexpr double longest = 0.2;         // of the scene's size
constexpr double shaft_radius = 0.006;  // of the scene's size, where the arrow is long enough for it
constexpr double slimmest = 0.045;      // a shaft's radius over its arrow's length, at most
constexpr double faintest = 0.01;       // of the largest force: less is not drawn
constexpr std::size_t most_arrows = 4;  // a load
constexpr Colour on_light{0.03, 0.43, 0.40}, on_dark{0.36, 0.80, 0.70};

bool merged(const Load& load) {
  return load.masses.size() > most_arrows;
}

double force_of_arrow(const Load& load) {
  return load.force.norm() * (merged(load) ? static_cast<double>(load.masses.size()) : 1.0);
}

}  // namespace

std::vector<RodRecord> load_arrows(const Drawn& drawn, const std::vector<Vec3>& turned, double size,
                                   const std::vector<double>& gap) {
  const Model& model = drawn.model;
  const State& state = drawn.state;
  double largest = 0.0;
  for (const Load& load : model.loads) largest = std::max(largest, force_of_arrow(load));
  std::vector<RodRecord> arrows;
  const Rgba colour = opaque(drawn.look.theme == Theme::dark ? on_dark : on_light);
  for (std::size_t i = 0; i < model.loads.size(); ++i) {
    const Load& load = model.loads[i];
    const double share = largest > 0.0 ? force_of_arrow(load) * load.share(state.time) / largest : 0.0;
    std::vector<Index> pushed;
    std::ranges::copy_if(load.masses, std::back_inserter(pushed),
                         [&](Index mass) { return drawn.appearance.there[mass]; });
    if (share < faintest || pushed.empty()) continue;
    const double length = longest * size * share;
    const double radius = std::min(shaft_radius * size, slimmest * length);
    const Vec3 along = turned[i].normalized();
    const auto add = [&](const Vec3& place, double apart) {
      const Vec3 tip = place - along * apart;
      arrows.push_back({to_glm(tip - along * length), static_cast<float>(radius), to_glm(tip), colour});
    };
    Vec3 middle = Vec3::Zero();
    double most_apart = 0.0;
    for (const Index mass : pushed) {
      if (!merged(load)) add(state.position.at(mass), gap[mass]);
      middle += state.position.at(mass) / static_cast<double>(pushed.size());
      most_apart = std::max(most_apart, gap[mass]);
    }
    if (merged(load)) add(middle, most_apart);
  }
  return arrows;
}

}  // namespace taut
