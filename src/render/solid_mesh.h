#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "colour_scale.h"
#include "frame_block.h"
#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// One vertex of a solid as shaders/solid.vert reads it.
struct SolidVertex {
  glm::vec3 position;  ///< m
  glm::vec3 normal;    ///< unit vector, outwards
  Rgba colour;
};

struct SolidMesh {
  std::vector<SolidVertex> vertices;
  std::vector<Index> indices;
};

/// Adds a rod with round ends; a ball where both ends are one point (m).
void add_capsule(SolidMesh& mesh, const Vec3& a, const Vec3& b, double radius, const Colour& colour);

/// Adds a box with its edges' directions as columns (m).
void add_box(SolidMesh& mesh, const Box& box, const Colour& colour);

/// The bones of ragdolls, and balls of a colour of their own at their joints.
void add_bones(SolidMesh& mesh, const Model& model, const State& state, const Look& look,
               const Quantity& quantity, const ColourScale& scale);

/// Adds something to hit; nothing for a plane.
void add_shape(SolidMesh& mesh, const Shape& shape, const Colour& colour);

/// A box at each mass that is in no ragdoll, turned as its links have turned since the start.
void add_mass_boxes(SolidMesh& mesh, const Model& model, const State& start, const State& state,
                    const Look& look, double radius, const Quantity& quantity, const ColourScale& scale);

/// Widens bounds so that they hold the mesh.
Bounds with_mesh(Bounds bounds, const SolidMesh& mesh);

}  // namespace taut
