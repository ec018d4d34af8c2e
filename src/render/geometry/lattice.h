#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/colour_scale.h"
#include "model/model.h"
#include "model/state.h"
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

/// Whether each link is whole, of a family that the look names, and not drawn as bones.
std::vector<bool> links_to_draw(const Model& model, const State& state, const Look& look);

/// A mass's colour. `scale` is not used when the quantity is empty.
Colour mass_colour(const Model& model, const Look& look, const Radii& radii, const Quantity& quantity,
                   const ColourScale& scale, std::size_t mass);

/// Spheres for masses that are not drawn as bones or boxes, or where only links are drawn, for the joints
/// between them. In ropes and chains there are no masses to be seen but pins, heavy ones, and those that the
/// scene has beside its chains and sheets. `scale` is not used when the quantity is empty.
std::vector<SphereRecord> sphere_records(const Model& model, const State& state, const Look& look,
                                         const Radii& radii, const Quantity& quantity,
                                         const ColourScale& scale);

/// Ribbons for the links to draw, where they are drawn as rods.
std::vector<RodRecord> link_records(const Model& model, const State& state, const Look& look,
                                    const Radii& radii, const Quantity& quantity, const ColourScale& scale);

}  // namespace taut
