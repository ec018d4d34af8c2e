#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "geometry/bodies.h"
#include "geometry/colour_scale.h"
#include "geometry/ground_patch.h"
#include "geometry/lattice.h"
#include "geometry/lines.h"
#include "geometry/surface_mesh.h"
#include "geometry/torso.h"
#include "render/camera.h"
#include "render/geometry.h"

namespace taut {

/// An axis-parallel box (m).
struct DrawnBox {
  glm::vec3 low{0.0F}, high{0.0F};
};

/// Everything is in picture space (picture_space.h).
struct Geometry {
  CameraPose pose;
  std::vector<SphereRecord> spheres;
  std::vector<RodRecord> links;
  Lines lines;
  SurfaceMesh surface;  ///< without vertices where none is drawn
  Bodies bodies;
  std::vector<GroundPatch> grounds;  ///< those that are seen from above
  DrawnBox bounds;                   ///< of all but the grounds; the eye where there is nothing
  ColourScale scale;                 ///< of its colours, where they mean anything
  bool legend = false;               ///< whether anything may have a colour of the scale
  /// Beside cloth, which throws the shadow of its own lattice, so many of the first spheres and links throw
  /// one, and lines where `line_shadows`.
  std::size_t sphere_shadows = 0, link_shadows = 0;
  bool line_shadows = false;
  glm::dvec3 anchor{0.0};  ///< a place that no camera moves, for texels of shadows to keep to

  bool empty() const {
    return spheres.empty() && links.empty() && lines.empty() && surface.vertices.empty() && bodies.empty();
  }
};

/// Calls visit(centre, radius) with balls (m) that hold all that is drawn but the grounds, each within its
/// convex hull.
template <typename Visit>
void for_each_ball(const Geometry& geometry, const Visit& visit) {
  for (const SurfaceVertex& vertex : geometry.surface.vertices) visit(vertex.position, 0.0F);
  for (const SphereRecord& sphere : geometry.spheres) visit(sphere.centre, sphere.radius);
  for (const RodRecord& link : geometry.links) {
    visit(link.start, link.radius);
    visit(link.end, link.radius);
  }
  for_each_ball(geometry.lines, visit);
  for (const TaperedRod& rod : geometry.bodies.rods) {
    visit(rod.start, rod.start_radius);
    visit(rod.end, rod.end_radius);
  }
  for (const TorsoRecord& torso : geometry.bodies.torsos)
    for (const glm::vec3& corner : torso_corners())
      visit(torso.origin + corner.x * torso.axes[0] + corner.y * torso.axes[1] + corner.z * torso.axes[2],
            0.0F);
  for (const BoxRecord& box : geometry.bodies.boxes)
    for (int corner = 0; corner < 8; ++corner)
      visit(box.centre + ((corner & 1) != 0 ? box.edges[0] : -box.edges[0]) +
                ((corner & 2) != 0 ? box.edges[1] : -box.edges[1]) +
                ((corner & 4) != 0 ? box.edges[2] : -box.edges[2]),
            0.0F);
  for (const MeshRecord& mesh : geometry.bodies.meshes)
    for (const SolidVertex& vertex : mesh.surface->vertices)
      visit(mesh.centre + vertex.position.x * mesh.axes[0] + vertex.position.y * mesh.axes[1] +
                vertex.position.z * mesh.axes[2],
            0.0F);
}

}  // namespace taut
