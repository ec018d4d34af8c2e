#include "model/colliders.h"

#include <algorithm>
#include <cmath>

#include "model/solid_mesh.h"

namespace taut {
namespace {

Surface around(const Vec3& middle, double radius, const Vec3& point) {
  const Vec3 away = point - middle;
  const double distance = away.norm();
  return {distance - radius, distance > 0.0 ? Vec3(away / distance) : Vec3(Vec3::UnitY())};
}

Surface surface_of(const HalfSpace& plane, const Vec3& point) {
  return {(point - plane.point).dot(plane.normal), plane.normal};
}

Surface surface_of(const Sphere& sphere, const Vec3& point) {
  return around(sphere.centre, sphere.radius, point);
}

Surface surface_of(const Capsule& capsule, const Vec3& point) {
  const Vec3 span = capsule.b - capsule.a;
  const double share = std::clamp((point - capsule.a).dot(span) / span.squaredNorm(), 0.0, 1.0);
  return around(capsule.a + share * span, capsule.radius, point);
}

// Outside, the nearest point of the box; inside, the face that is nearest.
Surface surface_of(const Box& box, const Vec3& point) {
  const Vec3 local = box.axes.transpose() * (point - box.centre);
  const Vec3 beyond = local.cwiseAbs() - box.half_size;
  if ((beyond.array() > 0.0).any()) {
    const Vec3 nearest = local.cwiseMax(-box.half_size).cwiseMin(box.half_size);
    const double distance = (local - nearest).norm();
    return {distance, box.axes * ((local - nearest) / distance)};
  }
  int face = 0;
  const double depth = beyond.maxCoeff(&face);
  return {depth, box.axes.col(face) * (local[face] < 0.0 ? -1.0 : 1.0)};
}

Surface surface_of(const MeshSolid& solid, const Vec3& point) {
  const Surface own = solid.mesh->nearest(solid.back(point));
  return {own.distance, solid.axes * own.normal};
}

std::optional<Surface> within(const MeshSolid& solid, const Vec3& point, double reach) {
  std::optional<Surface> own = solid.mesh->within(solid.back(point), reach);
  if (own) own->normal = solid.axes * own->normal;
  return own;
}

template <class Solid>
std::optional<Surface> within(const Solid& solid, const Vec3& point, double reach) {
  const Surface surface = surface_of(solid, point);
  return surface.distance < reach ? std::optional(surface) : std::nullopt;
}

HalfSpace moved_shape(const HalfSpace& plane, const Placement& pose) {
  return {pose.place(plane.point), pose.turn * plane.normal};
}
Sphere moved_shape(const Sphere& sphere, const Placement& pose) {
  return {pose.place(sphere.centre), sphere.radius};
}
Capsule moved_shape(const Capsule& capsule, const Placement& pose) {
  return {pose.place(capsule.a), pose.place(capsule.b), capsule.radius};
}
Box moved_shape(const Box& box, const Placement& pose) {
  return {pose.place(box.centre), box.half_size, pose.turn * box.axes};
}
MeshSolid moved_shape(const MeshSolid& solid, const Placement& pose) {
  return {solid.mesh, pose.place(solid.centre), pose.turn * solid.axes};
}

}  // namespace

Shape moved(const Shape& shape, const Placement& pose) {
  return std::visit([&pose](const auto& solid) { return Shape(moved_shape(solid, pose)); }, shape);
}

Shape shape_at(const Collider& collider, double time) {
  return collider.motion ? moved(collider.shape, placement_at(*collider.motion, time)) : collider.shape;
}

Surface nearest_surface(const Shape& shape, const Vec3& point) {
  return std::visit([&point](const auto& solid) { return surface_of(solid, point); }, shape);
}

std::optional<Surface> surface_within(const Shape& shape, const Vec3& point, double reach) {
  return std::visit([&](const auto& solid) { return within(solid, point, reach); }, shape);
}

std::optional<Surface> surface_on_way(const Shape& shape, const Vec3& from, const Vec3& point, double reach) {
  const std::optional<Surface> near = surface_within(shape, point, reach);
  const auto* solid = std::get_if<MeshSolid>(&shape);
  if (solid == nullptr) return near;
  const bool inside = near && near->distance < 0.0;
  const SolidMesh::Crossing way = solid->mesh->crossing(solid->back(from), solid->back(point));
  if (!way.enters && !way.leaves && !inside) return near;
  Surface came;  // the plane by which it went in
  if (way.enters) {
    came.normal = solid->axes * way.normal;
    came.distance = (point - solid->place(way.place)).dot(came.normal);
  } else {
    // It was in it from the start, by rounding perhaps.
    const Surface start = surface_of(*solid, from);
    if (start.distance > 0.0) return near;
    came = {start.distance + (point - from).dot(start.normal), start.normal};
  }
  return inside && near->normal.dot(came.normal) >= 0.0 ? near : std::optional(came);
}

}  // namespace taut
