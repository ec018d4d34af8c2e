#include "geometry/picture_space.h"

namespace taut {
namespace {

HalfSpace moved(const PictureSpace& space, const HalfSpace& plane) {
  return {space.place(plane.point), space.direction(plane.normal)};
}

Sphere moved(const PictureSpace& space, const Sphere& sphere) {
  return {space.place(sphere.centre), sphere.radius};
}

Capsule moved(const PictureSpace& space, const Capsule& capsule) {
  return {space.place(capsule.a), space.place(capsule.b), capsule.radius};
}

Box moved(const PictureSpace& space, const Box& box) {
  Box result{space.place(box.centre), box.half_size, {}};
  for (int edge = 0; edge < 3; ++edge) result.axes.col(edge) = space.direction(box.axes.col(edge));
  return result;
}

MeshSolid moved(const PictureSpace& space, const MeshSolid& solid) {
  MeshSolid result{solid.mesh, space.place(solid.centre), {}};
  for (int axis = 0; axis < 3; ++axis) result.axes.col(axis) = space.direction(solid.axes.col(axis));
  return result;
}

}  // namespace

State PictureSpace::seen(const State& state) const {
  State result;
  result.time = state.time;
  result.position = state.position;
  for (std::size_t i = 0; i < state.position.size(); ++i) result.position.set(i, place(state.position.at(i)));
  result.broken_at = state.broken_at;
  return result;
}

Shape PictureSpace::seen(const Shape& shape) const {
  return std::visit([&](const auto& kind) { return Shape(moved(*this, kind)); }, shape);
}

}  // namespace taut
