#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/colour_scale.h"
#include "model/model.h"
#include "model/state.h"
#include "render/appearance.h"
#include "view/view.h"

namespace taut {

/// One sphere as shaders/sphere.vert reads it.
struct SphereRecord {
  glm::vec3 centre;  ///< m
  float radius;      ///< m
  Rgba colour;
};

/// A link, or a rod of a body, as shaders/link.vert and rod.vert read it.
struct RodRecord {
  glm::vec3 start;  ///< m
  float radius;     ///< m
  glm::vec3 end;    ///< m
  Rgba colour;
};

/// Radii that are drawn (m), and what shows the weight of masses.
struct Radii {
  double mass = 0.0, link = 0.0;  ///< of a mass of the median weight
  std::vector<double> of_mass;    ///< of each mass
  std::vector<double> shade;      ///< of each mass's colour, where it has its own and no quantity's
};

/// A look's radii, or where it has none a share of the model's median link length. A mass with a radius of
/// contact has that one, but that a pin always shows beside its links.
Radii radii(const Model& model, const Look& look);

/// What of a model is drawn, and how; `scale` is not used when the quantity is empty.
struct Drawn {
  const Model& model;
  const State& state;  ///< in picture space
  const Look& look;
  const Appearance& appearance;
  const Radii& radii;
  const Quantity& quantity;
  const ColourScale& scale;
};

/// Whether each link is drawn, and whole in a state.
std::vector<bool> links_to_draw(const Appearance& appearance, const State& state);

/// A mass's colour.
Colour mass_colour(const Drawn& drawn, std::size_t mass);
/// A link's colour.
Colour link_colour(const Drawn& drawn, std::size_t link);

/// Spheres for masses that are drawn as such, and for the joints between links whose masses are not.
std::vector<SphereRecord> sphere_records(const Drawn& drawn);

/// Ribbons for the links to draw, where they are drawn as rods.
std::vector<RodRecord> link_records(const Drawn& drawn);

}  // namespace taut
