#include "geometry/palette.h"

namespace taut {

Palette palette(Theme theme) {
  if (theme == Theme::dark) {
    return {.light = glm::vec3(1.00F, 0.95F, 0.87F) * 1.20F,
            .ambient_below = {0.10F, 0.10F, 0.11F},
            .ambient_above = {0.26F, 0.31F, 0.38F},
            .horizon = {0.17F, 0.19F, 0.22F},
            .sky = {0.07F, 0.08F, 0.11F},
            .ground = {0.045F, 0.050F, 0.058F},
            .grid_strength = -0.9F};
  }
  return {.light = glm::vec3(1.00F, 0.95F, 0.87F) * 1.45F,
          .ambient_below = {0.20F, 0.18F, 0.16F},
          .ambient_above = {0.42F, 0.47F, 0.55F},
          .horizon = {0.91F, 0.93F, 0.95F},
          .sky = {0.62F, 0.73F, 0.86F},
          .ground = {0.52F, 0.51F, 0.49F},
          .grid_strength = 0.22F};
}

glm::vec3 direction_to_light() {
  return glm::normalize(glm::vec3(0.68F, 1.0F, 0.56F));
}

}  // namespace taut
