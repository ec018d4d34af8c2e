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

Rgba link_colour(const Look& look, const Quantity& quantity, const ColourScale& scale, std::size_t link) {
  return opaque(quantity.of_link.empty() ? look.link_colour : scale.at(quantity.of_link[link]));
}

bool in_families(const Look& look, LinkFamily family) {
  return std::ranges::find(look.families, link_families[static_cast<std::size_t>(family)]) !=
         look.families.end();
}

// Whether each mass is part of a chain or a sheet.
std::vector<bool> of_chains_and_sheets(const Model& model) {
  std::vector<bool> part(model.masses.size(), false);
  const auto mark = [&](Index first, Index count) {
    for (Index mass = first; mass < first + count; ++mass) part[mass] = true;
  };
  for (const Chain& chain : model.chains) mark(chain.first_mass, chain.link_count + 1);
  for (const Sheet& sheet : model.sheets) mark(sheet.first_mass, sheet.rows * sheet.columns);
  return part;
}

// Whether each mass would not be seen in what its links are drawn as.
std::vector<bool> hidden_in_links(const Model& model, const Look& look) {
  if (look.link_shape == LinkShape::rod || !look.links) return std::vector<bool>(model.masses.size(), false);
  constexpr double heavy = 1.5;  // times the size of the median
  const std::vector<MassWeight> weights = mass_weights(model, look);
  std::vector<bool> hidden = of_chains_and_sheets(model);
  for (std::size_t mass = 0; mass < hidden.size(); ++mass)
    if (model.masses.pinned(mass) || weights[mass].size > heavy) hidden[mass] = false;
  return hidden;
}

// Whether each mass is part of bones that are drawn.
std::vector<bool> drawn_as_bones(const Model& model, const Look& look) {
  return look.bones ? in_ragdoll(model) : std::vector<bool>(model.masses.size(), false);
}

/// A sphere of the link's own thickness at each end of a whole link rounds off what would be a gap.
std::vector<SphereRecord> joints(const Model& model, const State& state, const Look& look, const Radii& radii,
                                 const Quantity& quantity, const ColourScale& scale) {
  std::vector<bool> seen = drawn_as_bones(model, look);
  const std::vector<bool> drawn = links_to_draw(model, state, look);
  std::vector<SphereRecord> records;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (!drawn[link]) continue;
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

Colour mass_colour(const Model& model, const Look& look, const Radii& radii, const Quantity& quantity,
                   const ColourScale& scale, std::size_t mass) {
  if (model.masses.pinned(mass)) return look.pin_colour;
  const auto shaded = [shade = radii.shade[mass]](const Colour& colour) {
    return Colour{shade * colour[0], shade * colour[1], shade * colour[2]};
  };
  if (look.colour_by == ColourBy::plain) return shaded(look.mass_colour);
  // Strain and tension belong to links; their masses step back so as not to compete with the colours.
  constexpr Colour neutral{0.62, 0.63, 0.65};
  const bool of_masses = look.colour_by == ColourBy::speed || look.colour_by == ColourBy::limit;
  return of_masses ? scale.at(quantity.of_mass[mass]) : shaded(neutral);
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

std::vector<bool> links_to_draw(const Model& model, const State& state, const Look& look) {
  std::vector<bool> drawn(model.links.size(), look.links);
  const std::vector<bool> boned = drawn_as_bones(model, look);
  for (std::size_t link = 0; link < drawn.size(); ++link)
    if (state.broken(link) || !in_families(look, model.links.family[link]) ||
        (boned[model.links.a[link]] && boned[model.links.b[link]]))
      drawn[link] = false;
  return drawn;
}

std::vector<SphereRecord> sphere_records(const Model& model, const State& state, const Look& look,
                                         const Radii& radii, const Quantity& quantity,
                                         const ColourScale& scale) {
  if (!look.masses || look.mass_shape == MassShape::box) {
    return look.links && look.link_shape == LinkShape::rod
               ? joints(model, state, look, radii, quantity, scale)
               : std::vector<SphereRecord>{};
  }
  std::vector<SphereRecord> records;
  records.reserve(model.masses.size());
  const std::vector<bool> boned = drawn_as_bones(model, look), hidden = hidden_in_links(model, look);
  for (std::size_t mass = 0; mass < model.masses.size(); ++mass) {
    if (boned[mass] || hidden[mass]) continue;
    records.push_back({to_glm(state.position.at(mass)), static_cast<float>(radii.of_mass[mass]),
                       opaque(mass_colour(model, look, radii, quantity, scale, mass))});
  }
  return records;
}

std::vector<RodRecord> link_records(const Model& model, const State& state, const Look& look,
                                    const Radii& radii, const Quantity& quantity, const ColourScale& scale) {
  std::vector<RodRecord> records;
  if (look.link_shape != LinkShape::rod) return records;
  records.reserve(model.links.size());
  const std::vector<bool> drawn = links_to_draw(model, state, look);
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (!drawn[link]) continue;
    records.push_back({to_glm(state.position.at(model.links.a[link])), static_cast<float>(radii.link),
                       to_glm(state.position.at(model.links.b[link])),
                       link_colour(look, quantity, scale, link)});
  }
  return records;
}

}  // namespace taut
