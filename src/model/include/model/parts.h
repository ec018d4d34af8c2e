#pragma once

#include <span>
#include <string>
#include <string_view>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Something that a scene may model or leave out.
struct Part {
  std::string_view name;                      ///< "drag"
  std::string (*extent)(const Model& model);  ///< how much of it there is, for people; empty: none
  void (*remove)(Model& model);               ///< the model without it
};

/// Every part, in the order in which they are explained.
std::span<const Part> model_parts();

/// True when every free mass has the same mass, so that links need no weights.
bool equal_masses(const Model& model);

/// How much of a net so many links between so many masses are: 0 for chains and trees, whose systems are
/// solved in one pass, to 1 where every other link, as in a net of rows and columns, or more close a ring.
double share_of_net(double links, double masses);

/// Whether any link has no stiffness.
bool has_rigid_links(const Model& model);

/// True when nothing ever leaves the plane through the start that is perpendicular to z: no position,
/// velocity, force, motion of a pin or ground has a part along z. Exact, so that leaving z out changes no
/// bit.
bool stays_in_plane(const Model& model, const State& start);

}  // namespace taut
