#pragma once

#include <glm/glm.hpp>

#include "view/view.h"

namespace taut {

/// Lights and surroundings of a theme. Light and ground are linear, the sky is as displayed.
struct Palette {
  glm::vec3 light, ambient_below, ambient_above;
  glm::vec3 horizon, sky;
  glm::vec3 ground;
  float grid_strength;  ///< share of the ground's brightness that a grid line takes; below 0 it adds
};

Palette palette(Theme theme);

/// Unit vector towards the key light, the same in every theme.
glm::vec3 direction_to_light();

/// How wide the key light is: tangent of the angle between its middle and its rim, seen from anywhere. A
/// penumbra is twice that wide a metre of the light's way from what throws the shadow.
inline constexpr float light_spread = 0.018F;

}  // namespace taut
