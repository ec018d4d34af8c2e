#include "render/ground.h"

#include <variant>

namespace taut {
namespace {

std::vector<Ground> planes_of(const Model& model, double time) {
  std::vector<Ground> planes;
  for (const Collider& collider : model.colliders)
    if (std::holds_alternative<HalfSpace>(collider.shape)) {
      const auto plane = std::get<HalfSpace>(shape_at(collider, time));
      planes.push_back({plane.point, plane.normal, true});
    }
  return planes;
}

}  // namespace

std::vector<Ground> drawn_grounds(const Model& model, const Look& look, const Vec3& up, double time) {
  if (!look.ground) return {};
  std::vector<Ground> grounds = planes_of(model, time);
  if (grounds.empty()) return {Ground{look.ground_height.value_or(0.0) * up, up, false}};
  constexpr double level = 1e-9;
  for (Ground& ground : grounds)
    if (look.ground_height && (ground.normal - up).norm() < level) ground.point = *look.ground_height * up;
  return grounds;
}

}  // namespace taut
