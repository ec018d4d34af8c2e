#include "breaking.h"

#include <cmath>

namespace taut {
namespace {

bool between_pins(const Model& model, Index link) {
  return model.masses.pinned(model.links.a[link]) && model.masses.pinned(model.links.b[link]);
}

// Whether a link is longer than its break_stretch allows. Nearly every link is far from that, and its square
// tells so without a root.
bool overstretched(const Model& model, const Vectors& position, Index link) {
  const double most = model.links.break_stretch[link] * model.links.length[link];
  const Vec3 difference = position.at(model.links.a[link]) - position.at(model.links.b[link]);
  const double square = difference.squaredNorm();
  return square > 0.999999 * (most * most) && std::sqrt(square) > most;
}

}  // namespace

std::vector<Index> links_over_threshold(const Model& model, const Capabilities& can, const State& state) {
  std::vector<Index> over;
  for (const Index link : model.breakable_links) {
    if (state.broken(link)) continue;
    const bool test_stretch = !can.breaks_within_step || between_pins(model, link);
    if (state.tension[link] > model.links.break_tension[link] ||
        (test_stretch && overstretched(model, state.position, link)))
      over.push_back(link);
  }
  return over;
}

}  // namespace taut
