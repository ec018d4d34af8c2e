#include "render/ground.h"

#include <variant>

#include "render/appearance.h"

namespace taut {
namespace {

struct Planes {
  bool any = false;  // whether the model has some, seen or not
  std::vector<Ground> seen;
};

Planes planes_of(const Model& model, const Look& look, double time) {
  Planes planes;
  std::size_t number = 0;
  for (const Collider& collider : model.colliders) {
    if (!std::holds_alternative<HalfSpace>(collider.shape)) continue;
    planes.any = true;
    const ObjectLook& own = look_of(look.objects.planes, number++);
    const auto plane = std::get<HalfSpace>(shape_at(collider, time));
    if (own.visible) planes.seen.push_back({plane.point, plane.normal, true, own.colour});
  }
  return planes;
}

}  // namespace

std::vector<Ground> drawn_grounds(const Model& model, const Look& look, const Vec3& up, double time) {
  if (!look.ground) return {};
  const Planes planes = planes_of(model, look, time);
  if (!planes.any) return {Ground{look.ground_height.value_or(0.0) * up, up, false}};
  std::vector<Ground> grounds = planes.seen;
  constexpr double level = 1e-9;
  for (Ground& ground : grounds)
    if (look.ground_height && (ground.normal - up).norm() < level) ground.point = *look.ground_height * up;
  return grounds;
}

}  // namespace taut
