#include "model/colliders.h"

#include <algorithm>
#include <cmath>

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

}  // namespace taut
