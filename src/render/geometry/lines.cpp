#include "geometry/lines.h"

#include <algorithm>

#include "geometry/load_arrows.h"
#include "geometry/view_matrices.h"

namespace taut {
namespace {

constexpr Colour ghost_on_light{0.0, 0.42, 0.72}, ghost_on_dark{0.45, 0.75, 0.95};
constexpr std::uint8_t ghost_alpha = 165;
constexpr double ghost_radius = 0.4;  // of a link's
constexpr Colour trail_on_light{0.80, 0.22, 0.12}, trail_on_dark{1.0, 0.62, 0.35};
constexpr double trail_alpha = 235.0;
constexpr double trail_radius = 0.8;  // of a link's

}  // namespace

void add_linked(Lines& lines, std::vector<SphereRecord>& balls, const Seen& seen) {
  const auto& [model, state, look, radii, quantity, scale] = seen;
  if (!look.links || look.link_shape == LinkShape::rod) return;
  const std::vector<LinkRun> runs = link_runs(model, links_to_draw(model, state, look));
  if (look.link_shape == LinkShape::chain) {
    lines.rings = chain_rings(model, state, runs, look, quantity, scale);
    return;
  }
  Ropes drawn = ropes(model, state, runs, look, radii.link, quantity, scale);
  lines.ropes = std::move(drawn.pieces);
  balls.insert(balls.end(), drawn.balls.begin(), drawn.balls.end());
}

void add_loads(Lines& lines, const Seen& seen, const PictureSpace& space, double size) {
  if (!seen.look.loads || seen.model.loads.empty()) return;
  std::vector<Vec3> turned;
  for (const Load& load : seen.model.loads) turned.push_back(space.direction(load.force));
  std::vector<double> gap = seen.radii.of_mass;
  for (double& apart : gap) apart = 1.3 * std::max(apart, seen.radii.link);
  lines.arrows = load_arrows(seen.model, seen.state, turned, seen.look, size, gap);
}

void add_ghost(Lines& lines, const Seen& seen, const State& other) {
  const auto& [model, state, look, radii, quantity, scale] = seen;
  Rgba colour = opaque(look.theme == Theme::dark ? ghost_on_dark : ghost_on_light);
  colour[3] = ghost_alpha;
  const std::vector<bool> drawn = links_to_draw(model, other, look);
  for (std::size_t link = 0; link < drawn.size(); ++link)
    if (drawn[link])
      lines.ghosts.push_back({to_glm(other.position.at(model.links.a[link])),
                              static_cast<float>(ghost_radius * radii.link),
                              to_glm(other.position.at(model.links.b[link])), colour});
}

void add_trails(Lines& lines, const Seen& seen, const PictureSpace& space, const Trails& trails) {
  const Look& look = seen.look;
  Rgba colour = opaque(look.theme == Theme::dark ? trail_on_dark : trail_on_light);
  for (const std::vector<TrailPoint>& trail : trails) {
    const double now = trail.back().time;
    const double back = look.trail_time > 0.0 ? look.trail_time : std::max(now, 1e-9);
    for (std::size_t i = 0; i + 1 < trail.size(); ++i) {
      const double age = (now - 0.5 * (trail[i].time + trail[i + 1].time)) / back;
      if (age >= 1.0) continue;
      // Thinner as well as fainter: of alpha alone a picture of few samples shows few steps.
      const auto radius = static_cast<float>(trail_radius * (1.0 - 0.5 * age) * seen.radii.link);
      colour[3] = static_cast<std::uint8_t>(trail_alpha * (1.0 - age));
      lines.ghosts.push_back(
          {to_glm(space.place(trail[i].place)), radius, to_glm(space.place(trail[i + 1].place)), colour});
    }
  }
}

}  // namespace taut
