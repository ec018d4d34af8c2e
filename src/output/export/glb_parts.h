#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "export/export_shape.h"
#include "output/export.h"

namespace taut {

/// What glTF calls the mode of a primitive.
enum class GlbMode : int { points = 0, lines = 1, triangles = 4 };

/// A part of a scene that is one mesh: vertices, each a mass, and what they are the corners of.
struct GlbPart {
  std::string name;
  GlbMode mode = GlbMode::triangles;
  std::vector<Index> masses;           ///< one a vertex
  std::vector<std::uint32_t> corners;  ///< vertices of points, lines or triangles, one after the other
  std::array<double, 3> colour{};      ///< as displayed
};

/// Every part of a scene while nothing is broken: its sheets with faces, its links, its lone masses.
std::vector<GlbPart> glb_parts(const ExportSubject& subject);

/// Normals (unit length) of a part's vertices, means of those of their triangles, the larger the more; along
/// z where there are none. Empty for lines and points.
std::vector<Vec3> glb_normals(const GlbPart& part, const Vectors& position);

}  // namespace taut
