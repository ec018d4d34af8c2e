#include "geometry/lattice.h"

#include <algorithm>

#include "geometry/mass_weight.h"
#include "geometry/view_matrices.h"

namespace taut {
namespace {

// So that a pin is seen whatever it holds; radii.
constexpr double pin_to_link = 2.2;

double median_link_length(const Model& model) {
  std::vector<double> lengths = model.links.length;
  if (lengths.empty()) return 0.2;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

// A sphere of the link's own thickness at each end of a whole link rounds off what would be a gap.
void add_joints(std::vector<SphereRecord>& records, const Drawn& drawn) {
  const auto& [model, state, look, appearance, radii, quantity, scale] = drawn;
  const bool spheres = look.mass_shape == MassShape::sphere;
  std::vector<bool> seen = appearance.in_body;
  if (spheres)
    for (std::size_t mass = 0; mass < seen.size(); ++mass) seen[mass] = seen[mass] || appearance.masses[mass];
  const std::vector<bool> links = links_to_draw(appearance, state);
  for (std::size_t link = 0; link < links.size(); ++link) {
    if (!links[link]) continue;
    for (const Index mass : {model.links.a[link], model.links.b[link]}) {
      if (seen[mass]) continue;
      seen[mass] = true;
      records.push_back({to_glm(state.position.at(mass)), static_cast<float>(radii.link),
                         opaque(link_colour(drawn, link))});
    }
  }
}

}  // namespace

Colour mass_colour(const Drawn& drawn, std::size_t mass) {
  const auto& [model, state, look, appearance, radii, quantity, scale] = drawn;
  const std::optional<Colour> own = own_mass_colour(appearance, mass);
  const bool single = mass >= model.singles.first_mass;
  if (model.masses.held(mass, state.time)) return own && single ? *own : look.pin_colour;
  const auto shaded = [shade = radii.shade[mass]](const Colour& colour) {
    return Colour{shade * colour[0], shade * colour[1], shade * colour[2]};
  };
  if (look.colour_by == ColourBy::plain) return own ? *own : shaded(look.mass_colour);
  // Strain and tension belong to links; their masses step back so as not to compete with the colours.
  constexpr Colour neutral{0.62, 0.63, 0.65};
  const bool of_masses = look.colour_by == ColourBy::speed || look.colour_by == ColourBy::limit;
  return of_masses ? scale.at(quantity.of_mass[mass]) : shaded(neutral);
}

Colour link_colour(const Drawn& drawn, std::size_t link) {
  if (!drawn.quantity.of_link.empty()) return drawn.scale.at(drawn.quantity.of_link[link]);
  return own_link_colour(drawn.appearance, link).value_or(drawn.look.link_colour);
}

Radii radii(const Model& model, const Look& look) {
  Radii result;
  result.mass = look.mass_radius > 0.0 ? look.mass_radius : 0.21 * median_link_length(model);
  result.link = look.link_radius > 0.0 ? look.link_radius : 0.42 * result.mass;
  const std::vector<MassWeight> weights = mass_weights(model, look);
  for (std::size_t mass = 0; mass < weights.size(); ++mass) {
    const double contact = model.masses.radius[mass];
    double radius = contact > 0.0 ? contact : weights[mass].size * result.mass;
    if (model.masses.pinned(mass)) radius = std::max(radius, pin_to_link * result.link);
    result.of_mass.push_back(radius);
    result.shade.push_back(contact > 0.0 ? 1.0 : weights[mass].shade);
  }
  return result;
}

std::vector<bool> links_to_draw(const Appearance& appearance, const State& state) {
  std::vector<bool> drawn = appearance.links;
  for (std::size_t link = 0; link < drawn.size(); ++link)
    if (state.broken(link)) drawn[link] = false;
  return drawn;
}

std::vector<SphereRecord> sphere_records(const Drawn& drawn) {
  const auto& [model, state, look, appearance, radii, quantity, scale] = drawn;
  std::vector<SphereRecord> records;
  if (look.mass_shape == MassShape::sphere) {
    records.reserve(model.masses.size());
    for (std::size_t mass = 0; mass < model.masses.size(); ++mass)
      if (appearance.masses[mass])
        records.push_back({to_glm(state.position.at(mass)), static_cast<float>(radii.of_mass[mass]),
                           opaque(mass_colour(drawn, mass))});
  }
  if (look.link_shape == LinkShape::rod) add_joints(records, drawn);
  return records;
}

std::vector<RodRecord> link_records(const Drawn& drawn) {
  std::vector<RodRecord> records;
  if (drawn.look.link_shape != LinkShape::rod) return records;
  const Links& links = drawn.model.links;
  records.reserve(links.size());
  const std::vector<bool> whole = links_to_draw(drawn.appearance, drawn.state);
  for (std::size_t link = 0; link < links.size(); ++link)
    if (whole[link])
      records.push_back({to_glm(drawn.state.position.at(links.a[link])), static_cast<float>(drawn.radii.link),
                         to_glm(drawn.state.position.at(links.b[link])), opaque(link_colour(drawn, link))});
  return records;
}

}  // namespace taut
