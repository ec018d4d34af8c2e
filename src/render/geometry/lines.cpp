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

// Runs parted where links have another colour of their own.
std::vector<LinkRun> of_one_colour(std::vector<LinkRun> runs, const Drawn& drawn) {
  const Appearance& appearance = drawn.appearance;
  if (appearance.link_colours.empty() || !drawn.quantity.of_link.empty()) return runs;
  std::vector<LinkRun> parted;
  for (const LinkRun& run : runs) {
    for (std::size_t i = 0; i < run.links.size(); ++i) {
      const bool same =
          i > 0 && appearance.link_colours[run.links[i]] == appearance.link_colours[run.links[i - 1]];
      if (!same) parted.emplace_back().masses.push_back(run.masses[i]);
      parted.back().links.push_back(run.links[i]);
      parted.back().masses.push_back(run.masses[i + 1]);
    }
  }
  return parted;
}

}  // namespace

void add_linked(Lines& lines, std::vector<SphereRecord>& balls, const Drawn& drawn) {
  const LinkShape shape = drawn.look.link_shape;
  if (shape == LinkShape::rod) return;
  const std::vector<LinkRun> runs =
      of_one_colour(link_runs(drawn.model, links_to_draw(drawn.appearance, drawn.state)), drawn);
  if (shape == LinkShape::chain) {
    lines.rings = chain_rings(drawn, runs);
    return;
  }
  Ropes made = ropes(drawn, runs);
  lines.ropes = std::move(made.pieces);
  balls.insert(balls.end(), made.balls.begin(), made.balls.end());
}

void add_loads(Lines& lines, const Drawn& drawn, const PictureSpace& space, double size) {
  if (!drawn.look.loads || drawn.model.loads.empty()) return;
  std::vector<Vec3> turned;
  for (const Load& load : drawn.model.loads) turned.push_back(space.direction(load.force));
  std::vector<double> gap = drawn.radii.of_mass;
  for (double& apart : gap) apart = 1.3 * std::max(apart, drawn.radii.link);
  lines.arrows = load_arrows(drawn, turned, size, gap);
}

void add_ghost(Lines& lines, const Drawn& drawn, const State& other) {
  const Model& model = drawn.model;
  Rgba colour = opaque(drawn.look.theme == Theme::dark ? ghost_on_dark : ghost_on_light);
  colour[3] = ghost_alpha;
  const std::vector<bool> links = links_to_draw(drawn.appearance, other);
  for (std::size_t link = 0; link < links.size(); ++link)
    if (links[link])
      lines.ghosts.push_back({to_glm(other.position.at(model.links.a[link])),
                              static_cast<float>(ghost_radius * drawn.radii.link),
                              to_glm(other.position.at(model.links.b[link])), colour});
}

void add_trails(Lines& lines, const Drawn& drawn, const PictureSpace& space, const Trails& trails) {
  const Look& look = drawn.look;
  Rgba colour = opaque(look.theme == Theme::dark ? trail_on_dark : trail_on_light);
  for (const std::vector<TrailPoint>& trail : trails) {
    const double now = trail.back().time;
    const double back = look.trail_time > 0.0 ? look.trail_time : std::max(now, 1e-9);
    for (std::size_t i = 0; i + 1 < trail.size(); ++i) {
      const double age = (now - 0.5 * (trail[i].time + trail[i + 1].time)) / back;
      if (age >= 1.0) continue;
      // Thinner as well as fainter: of alpha alone a picture of few samples shows few steps.
      const auto radius = static_cast<float>(trail_radius * (1.0 - 0.5 * age) * drawn.radii.link);
      colour[3] = static_cast<std::uint8_t>(trail_alpha * (1.0 - age));
      lines.ghosts.push_back(
          {to_glm(space.place(trail[i].place)), radius, to_glm(space.place(trail[i + 1].place)), colour});
    }
  }
}

}  // namespace taut
