#include <fmt/format.h>

#include "builder.h"
#include "model/measures.h"

namespace taut {
namespace {

constexpr double noticeable = 1e-3;  // of the scene's size, that something may be inside

bool is_held(const Model& model, const ContactPoint& point) {
  for (std::size_t k = 0; k < point.masses.size(); ++k)
    if (point.weights[k] != 0.0 && !model.masses.pinned(point.masses[k])) return false;
  return true;
}

}  // namespace

void find_starts_inside(const Builder& builder, const Description& description,
                        std::vector<Problem>& problems) {
  const Model& model = builder.model;
  const double allowed = noticeable * scene_size(model, builder.start);
  for (std::size_t i = 0; i < model.colliders.size(); ++i) {
    const Collider& collider = model.colliders[i];
    if (!collider.motion && !std::holds_alternative<MeshSolid>(collider.shape)) continue;
    const Shape shape = shape_at(collider, 0.0);
    for (const ContactPoint& point : model.contacts) {
      if (is_held(model, point)) continue;
      const std::optional<Surface> surface =
          surface_within(shape, value_at(point, builder.start.position), point.radius);
      const double depth = surface ? point.radius - surface->distance : 0.0;
      if (!(depth > allowed)) continue;
      const auto [section, index] = solid_entry(description, i);
      problems.push_back(
          {std::string(section), index, "",
           fmt::format("{}at the start \"{}\" is {:.4g} m inside it", collider.motion ? "it moves, and " : "",
                       model.masses.name[point.masses[0]], depth),
           ""});
      break;  // one tells of its kind
    }
  }
}

}  // namespace taut
