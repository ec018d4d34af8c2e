#include "geometry/lattice.h"

#include <algorithm>

#include "geometry/view_matrices.h"

namespace taut {
namespace {

double median_link_length(const Model& model) {
  std::vector<double> lengths = model.links.length;
  if (lengths.empty()) return 0.2;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

Rgba link_colour(const Look& look, const Quantity& quantity, const ColourScale& scale, std::size_t link) {
  return opaque(quantity.of_link.empty() ? look.link_colour : scale.at(quantity.of_link[link]));
}

// Whether each mass is part of bones that are drawn.
std::vector<bool> drawn_as_bones(const Model& model, const Look& look) {
  return look.bones ? in_ragdoll(model) : std::vector<bool>(model.masses.size(), false);
}

/// A sphere of the link's own thickness at each end of a whole link rounds off what would be a gap.
std::vector<SphereRecord> joints(const Model& model, const State& state, const Look& look, const Radii& radii,
                                 const Quantity& quantity, const ColourScale& scale) {
  std::vector<bool> seen = drawn_as_bones(model, look);
  std::vector<SphereRecord> records;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (state.broken(link)) continue;
    for (const Index mass : {model.links.a[link], model.links.b[link]}) {
      if (seen[mass]) continue;
      seen[mass] = true;
      records.push_back({to_glm(state.position.at(mass)), static_cast<float>(radii.link),
                         link_colour(look, quantity, scale, link)});
    }
  }
  return records;
}

}  // namespace

Colour mass_colour(const Model& model, const Look& look, const Quantity& quantity, const ColourScale& scale,
                   std::size_t mass) {
  if (model.masses.pinned(mass)) return look.pin_colour;
  if (look.colour_by == ColourBy::plain) return look.mass_colour;
  // Strain and tension belong to links; their masses step back so as not to compete with the colours.
  constexpr Colour neutral{0.62, 0.63, 0.65};
  const bool of_masses = look.colour_by == ColourBy::speed || look.colour_by == ColourBy::limit;
  return of_masses ? scale.at(quantity.of_mass[mass]) : neutral;
}

Radii radii(const Model& model, const Look& look) {
  Radii result;
  result.mass = look.mass_radius > 0.0 ? look.mass_radius : 0.29 * median_link_length(model);
  result.link = look.link_radius > 0.0 ? look.link_radius : 0.42 * result.mass;
  return result;
}

std::vector<SphereRecord> sphere_records(const Model& model, const State& state, const Look& look,
                                         const Radii& radii, const Quantity& quantity,
                                         const ColourScale& scale) {
  if (!look.masses || look.mass_shape == MassShape::box) {
    return look.links ? joints(model, state, look, radii, quantity, scale) : std::vector<SphereRecord>{};
  }
  std::vector<SphereRecord> records;
  records.reserve(model.masses.size());
  const std::vector<bool> boned = drawn_as_bones(model, look);
  for (std::size_t mass = 0; mass < model.masses.size(); ++mass) {
    if (boned[mass]) continue;
    const double radius = model.masses.radius[mass] > 0.0 ? model.masses.radius[mass] : radii.mass;
    records.push_back({to_glm(state.position.at(mass)), static_cast<float>(radius),
                       opaque(mass_colour(model, look, quantity, scale, mass))});
  }
  return records;
}

std::vector<RodRecord> link_records(const Model& model, const State& state, const Look& look,
                                    const Radii& radii, const Quantity& quantity, const ColourScale& scale) {
  std::vector<RodRecord> records;
  if (!look.links) return records;
  records.reserve(model.links.size());
  const std::vector<bool> boned = drawn_as_bones(model, look);
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (state.broken(link) || (boned[model.links.a[link]] && boned[model.links.b[link]])) continue;
    records.push_back({to_glm(state.position.at(model.links.a[link])), static_cast<float>(radii.link),
                       to_glm(state.position.at(model.links.b[link])),
                       link_colour(look, quantity, scale, link)});
  }
  return records;
}

}  // namespace taut
