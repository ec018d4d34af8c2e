#include "solid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lattice.h"
#include "model/orientation.h"
#include "view_matrices.h"

namespace taut {
namespace {

constexpr int sides = 20, rings = 6;  // round a capsule, and from the rim to the tip of an end

Colour mixed(const Colour& a, const Colour& b, double share) {
  return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share), std::lerp(a[2], b[2], share)};
}

Vec3 middle(const State& state, const std::array<Index, 2>& masses) {
  return 0.5 * (state.position.at(masses[0]) + state.position.at(masses[1]));
}

double mean_of(const std::vector<double>& values, const std::array<Index, 2>& masses) {
  return 0.5 * (values[masses[0]] + values[masses[1]]);
}

void add(SolidMesh& /*mesh*/, const HalfSpace& /*plane*/, const Colour& /*colour*/) {}
void add(SolidMesh& mesh, const Sphere& sphere, const Colour& colour) {
  add_capsule(mesh, sphere.centre, sphere.centre, sphere.radius, colour);
}
void add(SolidMesh& mesh, const Capsule& capsule, const Colour& colour) {
  add_capsule(mesh, capsule.a, capsule.b, capsule.radius, colour);
}
void add(SolidMesh& mesh, const Box& box, const Colour& colour) {
  add_box(mesh, box, colour);
}

// Joints stand out a little from the bones that meet in them: in colour, and by a hair in size.
constexpr double joint_swell = 1.06;

Colour bone_colour(const Look& look, const Bone& bone, const Quantity& quantity, const ColourScale& scale) {
  constexpr Colour neutral{0.66, 0.67, 0.69};
  if (look.colour_by == ColourBy::plain) return look.bone_colour;
  if (look.colour_by == ColourBy::limit) return neutral;
  return scale.at(0.5 * (mean_of(quantity.of_mass, bone.from) + mean_of(quantity.of_mass, bone.to)));
}

Colour joint_colour(const Look& look, const std::array<Index, 2>& joint, const Colour& bone,
                    const Quantity& quantity, const ColourScale& scale) {
  if (look.colour_by == ColourBy::limit)
    return scale.at(std::max(quantity.of_mass[joint[0]], quantity.of_mass[joint[1]]));
  return mixed(bone, {0.0, 0.0, 0.0}, 0.22);
}

}  // namespace

void add_capsule(SolidMesh& mesh, const Vec3& a, const Vec3& b, double radius, const Colour& colour) {
  const Vec3 span = b - a;
  const Vec3 axis = span.squaredNorm() > 0.0 ? Vec3(span.normalized()) : Vec3(Vec3::UnitY());
  const Vec3 right = axis.unitOrthogonal(), ahead = axis.cross(right);
  const auto first = static_cast<Index>(mesh.vertices.size());
  const Rgba paint = opaque(colour);
  // Circles of latitude from the tip at a to the tip at b; the rim is there twice, once at either end.
  for (int ring = 0; ring <= 2 * rings + 1; ++ring) {
    const bool at_a = ring <= rings;
    const double latitude = 0.5 * std::numbers::pi * ((at_a ? ring : ring - 1) - rings) / rings;
    for (int side = 0; side < sides; ++side) {
      const double longitude = 2.0 * std::numbers::pi * side / sides;
      const Vec3 normal = std::sin(latitude) * axis +
                          std::cos(latitude) * (std::cos(longitude) * right + std::sin(longitude) * ahead);
      mesh.vertices.push_back({to_glm((at_a ? a : b) + radius * normal), to_glm(normal), paint});
    }
  }
  for (Index ring = 0; ring < 2 * rings + 1; ++ring)
    for (Index side = 0; side < sides; ++side) {
      const Index low = first + ring * sides, next = (side + 1) % sides;
      for (const Index corner :
           {low + side, low + next, low + sides + side, low + sides + side, low + next, low + sides + next})
        mesh.indices.push_back(corner);
    }
}

void add_box(SolidMesh& mesh, const Box& box, const Colour& colour) {
  const Rgba paint = opaque(colour);
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const double side = face % 2 == 0 ? 1.0 : -1.0;
    const auto first = static_cast<Index>(mesh.vertices.size());
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 local;
      local[axis] = side * box.half_size[axis];
      local[(axis + 1) % 3] = (corner % 2 == 0 ? -1.0 : 1.0) * box.half_size[(axis + 1) % 3];
      local[(axis + 2) % 3] = (corner / 2 == 0 ? -1.0 : 1.0) * box.half_size[(axis + 2) % 3];
      mesh.vertices.push_back(
          {to_glm(box.centre + box.axes * local), to_glm(side * box.axes.col(axis)), paint});
    }
    for (const Index corner : {0U, 1U, 2U, 2U, 1U, 3U}) mesh.indices.push_back(first + corner);
  }
}

void add_bones(SolidMesh& mesh, const Model& model, const State& state, const Look& look,
               const Quantity& quantity, const ColourScale& scale) {
  for (const Bone& bone : model.bones) {
    const Colour colour = bone_colour(look, bone, quantity, scale);
    add_capsule(mesh, middle(state, bone.from), middle(state, bone.to), bone.radius, colour);
    if (bone.from == bone.to) continue;
    for (const auto& joint : {bone.from, bone.to}) {
      const Vec3 at = middle(state, joint);
      add_capsule(mesh, at, at, joint_swell * bone.radius,
                  joint_colour(look, joint, colour, quantity, scale));
    }
  }
}

void add_shape(SolidMesh& mesh, const Shape& shape, const Colour& colour) {
  std::visit([&](const auto& kind) { add(mesh, kind, colour); }, shape);
}

void add_mass_boxes(SolidMesh& mesh, const Model& model, const State& start, const State& state,
                    const Look& look, double radius, const Quantity& quantity, const ColourScale& scale) {
  const std::vector<Eigen::Quaterniond> turns = orientations(model, start, state);
  const std::vector<bool> boned = in_ragdoll(model);
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    if (boned[i]) continue;
    const double half = std::max(model.masses.radius[i], radius);
    add_box(mesh, {state.position.at(i), Vec3::Constant(half), turns[i].toRotationMatrix()},
            mass_colour(model, look, quantity, scale, i));
  }
}

Bounds with_mesh(Bounds bounds, const SolidMesh& mesh) {
  for (const SolidVertex& vertex : mesh.vertices) {
    bounds.low = glm::min(bounds.low, vertex.position);
    bounds.high = glm::max(bounds.high, vertex.position);
  }
  return bounds;
}

}  // namespace taut
