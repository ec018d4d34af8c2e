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

/// Radii that are drawn (m).
struct Radii {
  double mass = 0.0, link = 0.0;
};

/// A look's radii, or where it has none a share of the model's median link length.
Radii radii(const Model& model, const Look& look);

/// A mass's colour. `scale` is not used when the quantity is empty.
Colour mass_colour(const Model& model, const Look& look, const Quantity& quantity, const ColourScale& scale,
                   std::size_t mass);

/// Spheres for masses that are not drawn as bones or boxes, or where only links are drawn, for the joints
/// between them. `scale` is not used when the quantity is empty.
std::vector<SphereRecord> sphere_records(const Model& model, const State& state, const Look& look,
                                         const Radii& radii, const Quantity& quantity,
                                         const ColourScale& scale);

/// Ribbons for the links that are whole.
std::vector<RodRecord> link_records(const Model& model, const State& state, const Look& look,
                                    const Radii& radii, const Quantity& quantity, const ColourScale& scale);

}  // namespace taut
