#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "geometry/surface_records.h"

namespace taut {

/// Small balls, sorted by where they are, so that those near a place are found in few runs.
class Occluders {
 public:
  /// `areas` (m²): of their outlines; those without one are left out. All places have to be finite.
  Occluders(const std::vector<glm::vec3>& places, const std::vector<float>& areas, float reach);

  /// How much of the light from all around they keep from the front (x) and the back (y) of a small flat
  /// thing, less the farther they are, and nothing from `reach` on.
  glm::vec2 hidden(const glm::vec3& place, const glm::vec3& normal) const;

 private:
  glm::ivec3 cell_at(const glm::vec3& place) const;
  std::size_t number_of(const glm::ivec3& cell) const;

  float reach_, cell_size_;
  glm::vec3 low_{0.0F};
  glm::ivec3 cells_{1};
  std::vector<Index> first_;  // of each cell's balls, and one more
  std::array<std::vector<float>, 3> places_;
  std::vector<float> areas_;
};

}  // namespace taut
