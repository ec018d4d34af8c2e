#include "geometry/bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/lattice.h"
#include "geometry/view_matrices.h"
#include "model/orientation.h"

namespace taut {
namespace {

BoxRecord box_record(const Box& box, const Colour& colour) {
  BoxRecord record{to_glm(box.centre), {}, opaque(colour)};
  for (int axis = 0; axis < 3; ++axis) record.edges[axis] = to_glm(box.half_size[axis] * box.axes.col(axis));
  return record;
}

void add(Bodies& /*bodies*/, const HalfSpace& /*plane*/, const Colour& /*colour*/) {}
void add(Bodies& /*bodies*/, const MeshSolid& /*solid*/, const Colour& /*colour*/) {}
void add(Bodies& bodies, const Sphere& sphere, const Colour& colour) {
  bodies.rods.push_back(tapered_rod(sphere.centre, sphere.radius, sphere.centre, sphere.radius, colour));
}
void add(Bodies& bodies, const Capsule& capsule, const Colour& colour) {
  bodies.rods.push_back(tapered_rod(capsule.a, capsule.radius, capsule.b, capsule.radius, colour));
}
void add(Bodies& bodies, const Box& box, const Colour& colour) {
  bodies.boxes.push_back(box_record(box, colour));
}

}  // namespace

TaperedRod tapered_rod(const Vec3& start, double start_radius, const Vec3& end, double end_radius,
                       const Colour& colour) {
  return {to_glm(start),   static_cast<float>(start_radius),
          to_glm(end),     static_cast<float>(end_radius),
          glm::vec3(0.0F), opaque(colour),
          opaque(colour)};
}

TaperedRod squeezed_ball(const Vec3& centre, double radius, const Vec3& axis, double thickness,
                         const Colour& colour) {
  TaperedRod ball = tapered_rod(centre, radius, centre, radius, colour);
  ball.squeeze = to_glm(std::sqrt(1.0 - thickness) * axis);
  return ball;
}

void add_mesh(Bodies& bodies, const MeshSolid& solid, const std::shared_ptr<const SolidSurface>& surface,
              const Colour& colour) {
  MeshRecord record{surface, to_glm(solid.centre), {}, opaque(colour)};
  for (int axis = 0; axis < 3; ++axis) record.axes[axis] = to_glm(solid.axes.col(axis));
  bodies.meshes.push_back(std::move(record));
}

void add_shape(Bodies& bodies, const Shape& shape, const Colour& colour) {
  std::visit([&](const auto& kind) { add(bodies, kind, colour); }, shape);
}

void add_mass_boxes(Bodies& bodies, const State& start, const Drawn& drawn) {
  const Model& model = drawn.model;
  const std::vector<Eigen::Quaterniond> turns = orientations(model, start, drawn.state);
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    if (!drawn.appearance.masses[i]) continue;
    const double contact = model.masses.radius[i];
    const double half = contact > 0.0 ? std::max(contact, drawn.radii.mass) : drawn.radii.of_mass[i];
    bodies.boxes.push_back(
        box_record({drawn.state.position.at(i), Vec3::Constant(half), turns[i].toRotationMatrix()},
                   mass_colour(drawn, i)));
  }
}

}  // namespace taut
